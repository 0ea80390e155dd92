// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/knob_condition.h"

#include "tb/base/errors.h"
#include "tb/scene/table_reader.h"
#include "tb/sweep/sweep_point.h"

namespace racebeam {

namespace {

ExpressionNames names_of(const engine& of, std::vector<double>& values) {
  const auto row_of = [&of](const std::string& name) { return swept_knob(of, name); };
  return {"knob", "value", "fifo_entries <= 8",
          [=, &of, &values](const std::string& name) {
            const knob_row* row = row_of(name);
            if (!row)
              throw UsageError("there is no knob " + quoted(name) + "; " +
                               name_help(name, swept_knobs(of)));
            return &values[static_cast<std::size_t>(row - of.knobs.data())];
          },
          [=](const std::string& name) {
            const knob_row* row = row_of(name);
            return row && !row->names.empty() ? &row->names : nullptr;
          }};
}

}  // namespace

KnobCondition::KnobCondition(const engine& of, const std::string& text)
    : values_(of.knobs.size()), expression_("where", text, names_of(of, values_)) {}

bool KnobCondition::holds(const knob_values& k) {
  for (std::size_t i = 0; i < values_.size(); ++i) values_[i] = k[i];
  return expression_.holds();
}

}  // namespace racebeam
