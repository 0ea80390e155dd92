// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/knob_condition.h"

#include "tb/base/errors.h"
#include "tb/scene/table_reader.h"
#include "tb/sweep/sweep_point.h"

namespace racebeam {

namespace {

ExpressionNames names_of(std::vector<double>& values) {
  const auto row_of = [](const std::string& name) { return swept_knob(name); };
  return {"knob", "value", "fifo_entries <= 8",
          [=, &values](const std::string& name) {
            const knob_info* row = row_of(name);
            if (!row)
              throw UsageError("there is no knob " + quoted(name) + "; " +
                               name_help(name, swept_knobs()));
            return &values[static_cast<std::size_t>(row - knob_table().data())];
          },
          [=](const std::string& name) {
            const knob_info* row = row_of(name);
            return row && !row->names.empty() ? &row->names : nullptr;
          }};
}

}  // namespace

KnobCondition::KnobCondition(const std::string& text)
    : values_(knob_table().size()), expression_("where", text, names_of(values_)) {}

bool KnobCondition::holds(const knobs& k) {
  const auto& table = knob_table();
  for (std::size_t i = 0; i < table.size(); ++i) values_[i] = k.*table[i].member;
  return expression_.holds();
}

}  // namespace racebeam
