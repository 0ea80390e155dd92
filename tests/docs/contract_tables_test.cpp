// docs/contract.md: its tables are what the model does.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>

#include "sc/beam/tlm/chip_lines.h"
#include "tb/show/demo_parts.h"
#include "tests/support/document.h"

namespace racebeam {
namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::Pair;

std::vector<std::vector<std::string>> rows(const std::string& heading, int table = -1) {
  return table_rows(page("docs/contract.md"), heading, table);
}
vec3 vector_of(const std::string& cell) {
  const auto all = numbers(cell);
  EXPECT_EQ(all.size(), 3u) << cell;
  return {all.at(0), all.at(1), all.at(2)};
}

/// The cores from the start of a frame on.
struct Chip : chip_core {
  explicit Chip(int frame) { deposit(frame, k); }
  /// To a clock of line `y`, of this frame.
  void go_to(int y, int clock) {
    const int left = (y - vga_timing.v_pos_q) * 1600 + clock - this->clock_of_line;
    for (int n = 0; n < left; ++n) clock_video(true, k);
    clock_of_line = clock;
  }
  const knobs k;
  int clock_of_line = 0;
};

/// What is counted in a frame.
frame_stats counted(int frame) {
  chip_lines lines({});
  lines.deposit(frame);
  lines.run_line();
  while (lines.next_line() != FirstLine) lines.run_line();
  return lines.take_stats();
}

TEST(ContractTables, ClocksOfAFrame) {
  for (const auto& row : rows("### 5.6")) {
    knobs k;
    k.speed = std::stoi(row[0]);
    vga_timing_core raster;
    int clocks = 0;
    for (bool end = false; !end; ++clocks) {
      end = raster.comb({true, k.speed}, k.clocks_per_pixel).frame_end;
      raster.clock({true, k.speed}, k.clocks_per_pixel);
    }
    EXPECT_EQ(clocks, std::stoi(row[1])) << "speed " << k.speed;
  }
}

TEST(ContractTables, ClocksOfALine) {
  Chip chip(2);
  for (const auto& row : rows("## 6. ", 1)) {
    chip.go_to(FirstLine, std::stoi(row[0]));
    const auto t = chip.vga_timing.comb({true, 0}, chip.k.clocks_per_pixel);
    EXPECT_EQ(chip.vga_timing.h_pos_q, std::stoi(row[1])) << row[0];
    EXPECT_EQ(chip.vga_timing.half_q, std::stoi(row[2])) << row[0];
    EXPECT_EQ(t.x2, std::stoi(row[3])) << row[0];
    EXPECT_EQ(t.active_start, row[4] == "`active_start`") << row[0];
    EXPECT_EQ(t.consume, row[4] == "`consume`" || row[4] == "`line_end`") << row[0];
    EXPECT_EQ(t.line_end, row[4] == "`line_end`") << row[0];
  }
}

TEST(ContractTables, TheCameraOfALine) {
  Chip chip(2);
  for (const auto& row : rows("### 7.7")) {
    chip.go_to(-240, std::stoi(row[0]));
    const auto& camera = chip.camera_unit;
    EXPECT_THAT(row, testing::SizeIs(8));
    EXPECT_EQ(row[1], std::to_string(camera.pass_q) + "." + std::to_string(camera.phase_q));
    EXPECT_EQ(row[2], std::to_string(camera.pstage_q) + "." + std::to_string(camera.pclk_q));
    EXPECT_EQ(row[3], std::to_string(chip.subdivider.idx2_q)) << "clock " << row[0];
    EXPECT_EQ(row[4], std::to_string(chip.subdivider.i2_q)) << "clock " << row[0];
    const auto unsigned_10 = [](const vec3& v) {
      return vec3{v[0] & 1023, v[1] & 1023, v[2] & 1023};
    };
    EXPECT_EQ(unsigned_10(vector_of(row[5])), unsigned_10(chip.ray_stepper.dr2_q)) << row[0];
    if (!row[6].empty()) {
      EXPECT_EQ(vector_of(row[6]), chip.ray_stepper.dr1_q) << row[0];
    }
    if (!row[7].empty()) {
      EXPECT_EQ(vector_of(row[7]), camera.ddr_q) << row[0];
    }
  }
}

TEST(ContractTables, TheTracerOfALine) {
  Chip chip(2);
  for (const auto& row : rows("### 9.9")) {
    chip.go_to(-240, std::stoi(row[0]));
    const auto& s = chip.subdivider;
    const char* const states[] = {"LEFT", "RIGHT", "BISECT", "RETURN"};
    EXPECT_EQ(row[1], states[s.state_q]) << "clock " << row[0];
    EXPECT_THAT(numbers(row[2] + " " + row[3] + " " + row[5]),
                ElementsAre(s.i1_q, s.i2_q, s.idx2_q));
    const auto& d = chip.decision_datapath;
    if (!row[6].empty()) {
      EXPECT_EQ(row[6], std::to_string(d.depth_q) + "." + std::to_string(d.level_q)) << row[0];
    }
  }
}

TEST(ContractTables, TheCornerOfALine) {
  Chip chip(2);
  for (const auto& row : rows("### 11.10")) {
    chip.go_to(-240, std::stoi(row[0]));
    const auto& d = chip.decision_datapath;
    EXPECT_EQ(row[1], std::to_string(d.depth_q) + "." + std::to_string(d.level_q)) << row[0];
    EXPECT_EQ(vector_of(row[2]), d.corner_q) << "clock " << row[0];
    EXPECT_THAT(numbers(row[3]), ElementsAre(d.room_q & 15, d.room_q >> 4)) << "clock " << row[0];
    EXPECT_EQ(row[4], std::to_string(d.second_q)) << "clock " << row[0];
  }
}

TEST(ContractTables, TheNavigatorOfAFrame) {
  Chip chip(129);
  const std::pair<const char*, int> states[] = {{"ADJUST", NavAdjust},
                                                {"TO_PLUS", NavToPlus},
                                                {"CHECK_PLUS", NavCheckPlus},
                                                {"FINISH", NavFinish},
                                                {"STORE", NavStore}};
  for (const auto& row : rows("## 13. ", 1)) {
    chip.go_to(LastLine, std::stoi(row[0]));
    EXPECT_THAT(states, testing::Contains(Pair(row[1], chip.navigator.nav_state_q))) << row[0];
    EXPECT_EQ(vector_of(row[2]), chip.decision_datapath.corner_q) << "clock " << row[0];
    EXPECT_EQ(std::stoi(row[3]), chip.decision_datapath.room_q >> 4) << "clock " << row[0];
  }
}

TEST(ContractTables, ClosestPowersOfTwo) {
  int next = 1;
  for (const auto& row : rows("### 9.5")) {
    const auto range = numbers(row[0]);
    EXPECT_EQ(range.at(0), next);
    for (; next <= range.at(1); ++next) {
      EXPECT_EQ(closest_power_of_two(next), 1 << std::stoi(row[1])) << next;
      EXPECT_EQ(closest_power_of_two(-next - 1), 1 << std::stoi(row[1])) << -next - 1;
    }
  }
  EXPECT_EQ(next, 2048);
}

TEST(ContractTables, WalksOfIdx2) {
  for (const auto& row : rows("### 20.2")) {
    int at = std::stoi(row[0]);
    const int to = std::stoi(row[1]);
    std::string steps;
    while (at != to) {
      const int step = closest_power_of_two(2 * (to - at)) * (to > at ? 1 : -1);
      steps += (steps.empty() ? "" : " ") + std::string(step > 0 ? "+" : "") + std::to_string(step);
      at += step;
    }
    EXPECT_EQ(steps, row[2]) << row[0] << " to " << row[1];
  }
}

TEST(ContractTables, TruncatedProducts) {
  for (const auto& row : rows("### 20.3"))
    EXPECT_EQ(truncated_product(std::stoi(row[0]), std::stoi(row[1]), 5), std::stoi(row[2]));
}

TEST(ContractTables, DitheredShading) {
  for (const auto& row : rows("### 15.1"))
    for (int i = 0; i < 4; ++i)
      EXPECT_EQ(pixel_output_core::value(row[0][0] - 'x', i < 2 ? 0 : 7, i & 1, true, false, {}),
                std::stoi(row[i + 1]))
          << row[0] << " " << i;
}

TEST(ContractTables, Palettes) {
  for (const auto& row : rows("### 15.2"))
    for (int palette = 0; palette < 3; ++palette) {
      const int colour = pixel_output_core::colour(
          {std::stoi(row[0]), false, false, true, true, true, {}, palette, 0, false}, {});
      const std::string rgb = std::to_string(colour >> 4) + std::to_string(colour >> 2 & 3) +
                              std::to_string(colour & 3);
      EXPECT_EQ(rgb, row[palette + 1]) << "index " << row[0] << " of palette " << palette;
    }
}

TEST(ContractTables, WhatTheSceneSelectorChooses) {
  constexpr int frames[] = {0, 8448, 4096, 6144, 9216, 10240, 12288, 9984};
  for (const auto& row : rows("### 17.1")) {
    sequencer_core sequencer;
    sequencer.frame_q = frames[std::stoi(row[0])];
    ASSERT_EQ(sequencer.scene_selector(), std::stoi(row[0]));
    const auto o = sequencer.comb({true, false, false, 0}, {});
    std::string flags;
    for (const auto& [flag, letter] :
         {std::pair{SceneWindows, "W"}, std::pair{ScenePortals, "P"}, std::pair{SceneHeights, "H"},
          std::pair{SceneTunnel, "U"}, std::pair{SceneBlocked, "B"}, std::pair{SceneNarrow, "N"}})
      if (o.scene_flags & flag) flags += (flags.empty() ? "" : " ") + std::string(letter);
    EXPECT_EQ(flags, row[1]);
    EXPECT_EQ(o.palette, numbers(row[2]).at(0)) << row[0];
    EXPECT_EQ(o.shading_b ? "B" : "A", row[3]) << row[0];
    EXPECT_EQ(o.start[1], std::stoi(row[4])) << row[0];
    EXPECT_EQ(o.velocity[2], std::stoi(row[5])) << row[0];
    EXPECT_EQ(o.scene_interlace ? "on" : "off", row[6]) << row[0];
  }
}

TEST(ContractTables, TheTimeline) {
  const auto table = rows("### 17.7");
  ASSERT_EQ(table.size(), demo_parts().size());
  for (std::size_t i = 0; i < table.size(); ++i) {
    const DemoPart& part = demo_parts()[i];
    EXPECT_THAT(table[i], ElementsAre(std::to_string(part.first_frame) + ".." +
                                          std::to_string(part.last_frame),
                                      std::to_string(part.selector), std::to_string(part.variant),
                                      part.scene, part.effects));
  }
}

TEST(ContractTables, CountersOfSingleFrames) {
  for (const auto& row : rows("### 19.1")) {
    const int frame = std::stoi(row[0]);
    const frame_stats s = counted(frame);
    const std::uint64_t counters[] = {
        s.left_decisions, s.right_decisions,  s.bisection_steps, s.adjust_steps,
        s.descents,       s.pushes,           s.emits,           s.give_ups,
        s.restarts,       s.fifo_full_stalls, s.starved_pixels};
    std::vector<std::uint64_t> told;
    for (int i = 2; i < 13; ++i) told.push_back(std::stoull(row[i]));
    EXPECT_THAT(told, ElementsAreArray(counters)) << "frame " << frame;
    const auto least_most = [](const std::vector<int>& clocks) {
      const auto [least, most] = std::minmax_element(clocks.begin(), clocks.end());
      return std::pair(*least, *most);
    };
    const auto camera = numbers(row[1]), done = numbers(row[13]);
    EXPECT_EQ(std::pair(camera.front(), camera.back()), least_most(s.camera_clocks)) << frame;
    EXPECT_EQ(std::pair(done.front(), done.back()), least_most(s.done_clock)) << frame;
  }
}

TEST(ContractTables, TheFramesThatStarveMost) {
  for (const auto& row : rows("### 19.2")) {
    const auto segment = numbers(row[0]);
    const int frame = std::stoi(row[1]);
    EXPECT_TRUE(segment.at(0) <= frame && frame <= segment.at(1)) << frame;
    EXPECT_EQ(counted(frame).starved_pixels, std::stoull(row[2])) << frame;
  }
}

TEST(ContractTables, ResultsOfTheCamera) {
  int frame = -1;
  std::unique_ptr<Chip> chip;
  for (const auto& row : rows("### 20.1")) {
    if (std::stoi(row[0]) != frame) chip = std::make_unique<Chip>(frame = std::stoi(row[0]));
    const int begin = std::stoi(row[2]);
    chip->go_to(std::stoi(row[1]), begin - 1);
    EXPECT_FALSE(chip->camera_unit.run()) << row[0] << " " << row[1];
    chip->go_to(std::stoi(row[1]), begin);
    EXPECT_TRUE(chip->camera_unit.run()) << row[0] << " " << row[1];
    EXPECT_EQ(chip->ray_stepper.dr1_q, vector_of(row[3])) << row[0] << " " << row[1];
    EXPECT_EQ(chip->camera_unit.ddr_q, vector_of(row[4])) << row[0] << " " << row[1];
  }
}

TEST(ContractTables, Rooms) {
  for (const auto& row : rows("### 20.4")) {
    SCOPED_TRACE(row[0] + ", room " + row[1] + ", " + row[2]);
    int flags = 0;
    for (const char letter : row[0])
      flags |= letter == 'W'   ? SceneWindows
               : letter == 'P' ? ScenePortals
               : letter == 'B' ? SceneBlocked
               : letter == 'H' ? SceneHeights
               : letter == 'U' ? SceneTunnel
               : letter == 'N' ? SceneNarrow
                               : 0;
    const auto id = [](const std::string& cell) {
      const vec3 place = vector_of(cell);
      return place[2] << 8 | place[1] << 4 | place[0];
    };
    const auto room = scene_core::geometry(flags, id(row[1]));
    EXPECT_EQ(room.position, vector_of(row[3]));
    EXPECT_EQ(room.half_size, vector_of(row[4]));
    EXPECT_EQ(scene_core::neighbour(flags, id(row[1]), row[2][1] - 'x', row[2][0] == '-'),
              row[5] == "none" ? SolidRoom : id(row[5]));
  }
}

}  // namespace
}  // namespace racebeam
