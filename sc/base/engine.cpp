// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/base/engine.h"

namespace racebeam {

std::vector<std::string> engine::unit_names(bool scene_file) const {
  std::vector<std::string> names;
  for (const unit_row& row : units)
    if (row.shows == unit_row::Always || (row.shows == unit_row::SceneFile) == scene_file)
      names.emplace_back(row.name);
  return names;
}

const unit_row* engine::unit(const std::string& name) const {
  for (const unit_row& row : units)
    if (row.name == name) return &row;
  return nullptr;
}

}  // namespace racebeam
