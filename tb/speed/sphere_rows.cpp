// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/speed/sphere_rows.h"

#include <fmt/format.h>

#include <cmath>

#include "sc/sphere/sphere_core.h"
#include "tb/host/sphere_motion.h"

namespace racebeam {

namespace {

constexpr int Numbers[] = {1, 2, 4, 6, 8, 10, 12, 15};
constexpr int Radius = 3;
constexpr double RingRadius = 10, Distance = 16, Pi = 3.14159265358979323846;
constexpr double SphereClock = 25.2e6;

std::vector<sphere_row> ring(int spheres) {
  std::vector<sphere_row> rows;
  for (int n = 0; n < spheres; ++n) {
    const double angle = 2 * Pi * n / spheres;
    rows.push_back(sphere_row::of(
        table_position({RingRadius * std::cos(angle), RingRadius * std::sin(angle), Distance}),
        Radius, {31, 31, 31}, 0));
  }
  return rows;
}

}  // namespace

nlohmann::json sphere_rows() {
  auto all = nlohmann::json::array();
  const sphere_knobs k;
  sphere_tables tables;
  for (const int spheres : Numbers) {
    tables.spheres = spheres;
    sphere_core core(k, tables, tables.board);
    core.load(ring(spheres));
    core.draw(tables.board);
    const double clocks = static_cast<double>(core.counters().clocks);
    all.push_back({{"spheres", spheres},
                   {"clocks", core.counters().clocks},
                   {"clocks_per_pixel", clocks / (core.columns() * core.rows())},
                   {"pictures_per_second", SphereClock / clocks}});
  }
  return all;
}

std::string sphere_text(const nlohmann::json& rows) {
  std::string text =
      "| spheres in a ring | clocks a pixel | pictures a second at 25.2 MHz |\n|--:|--:|--:|\n";
  for (const auto& row : rows)
    text += fmt::format("| {} | {:.2f} | {:.2f} |\n", row.at("spheres").get<int>(),
                        row.at("clocks_per_pixel").get<double>(),
                        row.at("pictures_per_second").get<double>());
  return text;
}

}  // namespace racebeam
