// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/parameter_condition.h"

#include <vector>

#include "tb/base/errors.h"
#include "tb/base/expression.h"

namespace racebeam {

bool holds_with(const RtlParameters& parameters, const std::string& when,
                const std::string& where) {
  if (when.empty()) return true;
  std::map<std::string, double> values;
  for (const auto& [name, value] : parameters) values[name] = static_cast<double>(value);
  const auto value_of = [&](const std::string& name) -> double* {
    const auto at = values.find(name);
    if (at == values.end()) throw UsageError("the RTL has no parameter " + name);
    return &at->second;
  };
  const auto no_words = [](const std::string&) {
    return static_cast<const std::vector<std::string>*>(nullptr);
  };
  Expression condition(where, when,
                       {"parameter", "value", "PortalsPerFace == 1", value_of, no_words});
  return condition.holds();
}

}  // namespace racebeam
