// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/area_figures.h"

#include <map>

#include "sc/swap/rtl_parameters.h"
#include "tb/scene/engines.h"

namespace racebeam {

namespace {

/// Parameters that are not those of the chip as it was built: "Cores=1 Lanes=2".
std::string other_parameters_text(const engine& built, const knob_values& k) {
  std::map<std::string, std::string> usual;
  for (const rtl_parameter& one : built.parameters(built.standard(nullptr)))
    usual[one.name] = std::to_string(one.value);
  std::string text;
  for (const rtl_parameter& one : built.parameters(k))
    if (const std::string value = std::to_string(one.value); usual[one.name] != value)
      text += (text.empty() ? "" : " ") + std::string(one.name) + "=" + value;
  return text;
}

}  // namespace

const std::vector<AreaFigures>& area_table() {
  static const std::vector<AreaFigures> table = {
#include "tb/report/area_figures.inc"
  };
  return table;
}

const AreaFigures* area_of(const knob_values& k) {
  const engine& built = engine_of(k);
  const std::string parameters = other_parameters_text(built, k);
  for (const AreaFigures& row : area_table())
    if (row.engine == built.name && row.parameters == parameters) return &row;
  return nullptr;
}

}  // namespace racebeam
