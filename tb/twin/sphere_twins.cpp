// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/sphere_twins.h"

#include <cstdint>
#include <string>
#include <vector>

#include "sc/sphere/sphere_parameters.h"
#include "tb/twin/table_file.h"

namespace racebeam {

PluginMaker sphere_plugins(const sphere_knobs& k, const sphere_tables& scene, bool traced) {
  std::string planes;
  for (const plane_row& plane : scene.planes) planes += plane_file_row(plane) + "\n";
  const auto table_of = [planes](const std::string& unit) -> std::vector<PluginMaker::Setting> {
    if (planes.empty() || (unit != "plane_table" && unit != "sphere_top")) return {};
    return {{"PlaneFile", table_file(planes), "the scene's table of planes"}};
  };
  return PluginMaker(sphere_parameters(k, scene), table_of, traced);
}

}  // namespace racebeam
