// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/speed/store_rows.h"

#include <fmt/format.h>

#include "tb/bench/store_traffic.h"

namespace racebeam {

namespace {

constexpr int Width = 320, Height = 240;
constexpr int Depths[] = {1, 8, 16, 24, 30, 31, 32, 38, 40, 42, 48, 64};
// Of the sphere tracer: the eye inside a sphere, nothing but the light, one sphere, four spheres.
constexpr int PixelClocks[] = {17, 19, 23, 35};

/// What a table is of.
struct Rule {
  int write_policy, when_full;
  const char *policy, *full;
  const char* figure;  ///< key of a row
  const char* title;
};
constexpr Rule Rules[] = {
    {WritePolicySync, WhenFullStall, "sync", "stall", "waited_percent",
     "clocks waited, % of those needed"},
    {WritePolicyBlanking, WhenFullStall, "blanking", "stall", "waited_percent",
     "clocks waited, % of those needed"},
    {WritePolicySync, WhenFullDrop, "sync", "drop", "lost_percent", "words lost, %"},
};

}  // namespace

nlohmann::json store_rows() {
  auto rows = nlohmann::json::array();
  for (const Rule& rule : Rules)
    for (const int depth : Depths)
      for (const int clocks : PixelClocks) {
        store_knobs k;
        k.write_buffer_depth = depth;
        k.write_policy = rule.write_policy;
        k.when_full = rule.when_full;
        const auto traffic = store_traffic(
            Width * Height, [clocks](int) { return clocks; }, k);
        rows.push_back({{"write_policy", rule.policy},
                        {"when_full", rule.full},
                        {"write_buffer_depth", depth},
                        {"pixel_clocks", clocks},
                        {"words", traffic.words},
                        {"lost", traffic.lost},
                        {"lost_percent", traffic.lost_percent()},
                        {"clocks", traffic.clocks},
                        {"waited", traffic.waited},
                        {"waited_percent", traffic.waited_percent()}});
      }
  return rows;
}

std::string store_tables(const nlohmann::json& rows) {
  std::string text;
  auto row = rows.begin();
  for (const Rule& rule : Rules) {
    text += fmt::format("store: {}; write_policy {}, when_full {}, {} x {} pixels\n", rule.title,
                        rule.policy, rule.full, Width, Height);
    text += fmt::format("{:>18}", "write_buffer_depth");
    for (const int clocks : PixelClocks) text += fmt::format(" {:>3} clocks/pixel", clocks);
    for (const int depth : Depths) {
      text += fmt::format("\n{:>18}", depth);
      for (std::size_t n = 0; n < std::size(PixelClocks); ++n, ++row)
        text += fmt::format(" {:>16.3f}", row->at(rule.figure).get<double>());
    }
    text += '\n';
  }
  return text;
}

}  // namespace racebeam
