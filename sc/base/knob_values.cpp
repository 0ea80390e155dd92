// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/base/knob_values.h"

#include <stdexcept>

namespace racebeam {

const std::vector<knob_row> knob_values::none;

std::string knob_row::text(int value) const {
  return names.empty() ? std::to_string(value) : names.at(value - min);
}

std::string knob_row::range() const {
  if (names.empty()) return std::to_string(min) + ".." + std::to_string(max);
  std::string all;
  for (const auto& name : names) all += (all.empty() ? "" : ", ") + name;
  return all;
}

knob_values::knob_values(const std::vector<knob_row>& rows, std::vector<int> values)
    : rows_(&rows), values_(std::move(values)) {
  if (values_.size() != rows.size()) throw std::logic_error("a knob without a value");
}

int knob_values::of(const std::string& name) const {
  for (std::size_t n = 0; n < rows_->size(); ++n)
    if (rows()[n].name == name) return values_[n];
  throw std::out_of_range("there is no knob " + name);
}

void expect_rows(const knob_values& values, const std::vector<knob_row>& rows) {
  if (&values.rows() != &rows) throw std::logic_error("knobs of another engine");
}

}  // namespace racebeam
