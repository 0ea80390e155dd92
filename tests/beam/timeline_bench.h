// timeline alone on the bench, and what its header says, in plain words.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <utility>

#include "sc/beam/knob_parameters.h"
#include "sc/beam/timeline.h"
#include "sc/swap/rtl_twin.h"
#include "tb/scene/program_tables.h"
#include "tb/verilate/rtl_plugin.h"
#include "tests/beam/beside.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {

constexpr int mod(int value, int size) { return (value % size + size) % size; }

inline const turn_row& turn_of(const shot_row& shot, int src) {
  return src == AngleYaw ? shot.yaw : src == AnglePitch ? shot.pitch : shot.fov;
}

/// The shot that holds at a frame.
inline int shot_at(const scene_program& program, int frame) {
  int found = 0;
  for (int i = 0; i < static_cast<int>(program.shots.size()); ++i)
    if (program.shots[i].frame <= frame) found = i;
  return found;
}

/// Angle or focal length: start, and step for every so many frames since the shot that set it.
inline int expected_angle(const scene_program& program, int frame, int src, int y) {
  const int now = shot_at(program, frame);
  int since = now;
  while (since > 0 && !turn_of(program.shots[since], src).load) --since;
  const turn_row& row = turn_of(program.shots[since], src);
  const int steps = (frame - program.shots[since].frame) / row.every;
  const int y9 = mod(y + 256, 512) - 256;
  const int value = row.start + steps * row.step + turn_of(program.shots[now], src).per_line * y9;
  return mod(value, src == AngleFov ? 256 : 2048);
}

/// A program with one shot, to be filled in.
inline scene_program one_shot(int frames) {
  scene_program program;
  program.frames = frames;
  program.rooms.resize(1);
  program.shots.resize(1);
  return program;
}

template <class Unit>
struct Dut {
  const scene_program program;
  Unit unit;
  UnitBench bench;

  explicit Dut(scene_program p, const knobs& k = {})
      : program(std::move(p)), unit("dut", program.fitted(k), program), bench(unit) {
    bench.clock();
    bench["rst_ni"].drive(1);
    bench.settle();
  }
  int get(const char* name) { return bench[name].value(); }
  /// Lets frames end.
  void count(int frames) {
    if (frames == 0) return;
    bench["frame_end_i"].drive(1);
    bench.clock(frames);
    bench["frame_end_i"].drive(0);
    bench.settle();
  }
  int angle(int src, int y) {
    bench["src_i"].drive(src);
    bench["y_i"].drive(y);
    bench.settle();
    return get("angle_o");
  }
  void tracer(int dr2_y, bool run) {
    bench["dr2_y_i"].drive(dr2_y);
    bench["run_i"].drive(run);
    bench.settle();
  }
  /// All that the shot chooses, at a frame, for some rays and lines.
  void check(int at) {
    SCOPED_TRACE(testing::Message() << "frame " << at);
    const shot_row& shot = program.shots[shot_at(program, at)];
    ASSERT_EQ(get("frame_o"), at);
    ASSERT_EQ(get("scene_flags_o"), 0);
    ASSERT_EQ(get("palette_o"), TablePalette);
    ASSERT_EQ(get("shading_b_o"), shot.shading_b);
    ASSERT_EQ(get("scene_interlace_o"), shot.interlace);
    ASSERT_EQ(get("inverse_o"), shot.inverse);
    ASSERT_EQ(bench.read("start"), shot.start);
    ASSERT_EQ(get("start_room_o"), shot.start_room);
    ASSERT_EQ(bench.read("velocity"), shot.velocity);
    ASSERT_EQ(get("nav_reset_o"), shot.restart && at == shot.frame);
    for (const int dr2_y : {0, 63, 64, 255, 256, -64, -65})
      for (const bool run : {false, true}) {
        tracer(dr2_y, run);
        const bool shown = shot.pattern == PatternFull ||
                           (shot.pattern == PatternPartial && (dr2_y >> 6 & 3) != 0);
        ASSERT_EQ(get("colours_o"), shown ? shot.pattern_colours : shot.colours) << dr2_y;
        ASSERT_EQ(get("lock_o"), shown && run) << dr2_y;
      }
    for (const int src : {AngleYaw, AnglePitch, AngleFov})
      for (const int y : {-273, -240, 0, 239})
        ASSERT_EQ(angle(src, y), expected_angle(program, at, src, y)) << src << ", y = " << y;
  }
};

/// Shots of a few frames each that choose anything; a turn that goes on repeats its row.
inline scene_program random_program(std::minstd_rand& random) {
  const auto between = [&](int low, int high) {
    return low + static_cast<int>((random() >> 4) % (high - low + 1));
  };
  scene_program program;
  program.rooms.resize(1);
  const int shots = between(1, 6);
  for (int s = 0, frame = 0; s < shots; ++s, frame += between(1, 12)) {
    shot_row shot = s ? program.shots.back() : shot_row{};
    shot.frame = frame;
    shot.restart = s == 0 || between(0, 1);
    shot.start_room = between(0, 8190);
    shot.start = {between(-32768, 32767), between(-32768, 32767), between(-32768, 32767)};
    shot.velocity = {between(-1024, 1023), between(-1024, 1023), between(-1024, 1023)};
    for (turn_row* turn : {&shot.yaw, &shot.pitch, &shot.fov}) {
      turn->load = s == 0 || between(0, 1);
      if (!turn->load) continue;
      *turn = {true, between(0, 2047), between(-2047, 2047), between(1, 9), between(-9, 9)};
    }
    shot.interlace = between(0, 1);
    shot.shading_b = between(0, 1);
    shot.inverse = between(0, 1);
    shot.pattern = between(0, 2);
    shot.colours = between(0, low_bits(ColoursBits));
    shot.pattern_colours = between(0, low_bits(ColoursBits));
    program.shots.push_back(shot);
    program.frames = frame + between(1, 12);
  }
  return program;
}

/// The folder that the RTL finds its table in: the process goes there.
class TableFolder {
 protected:
  explicit TableFolder(const scene_program& program) {
    std::ofstream(folder_ / Table) << shot_table(program);
    std::filesystem::current_path(folder_.path());
  }
  static constexpr const char* Table = "shots.hex";

 private:
  const ScratchFolder folder_;
};

/// The RTL for programs of up to eight shots.
class rtl_timeline : private TableFolder, public rtl_twin<timeline> {
 public:
  rtl_timeline(const sc_core::sc_module_name& name, const knobs& k, const scene_program& program)
      : TableFolder(program), rtl_twin(name, knob_parameters(k), plugin(k)) {}

 private:
  static std::string plugin(const knobs& k) {
    RtlSources sources{"timeline", {RACEBEAM_SOURCE_DIR "/rtl/beam/timeline.sv"}};
    sources.parameters = {"Shots=8", "ShotFile=\"" + std::string(Table) + "\"",
                          "DrBits=" + std::to_string(k.dr_bits)};
    return rtl_plugin(sources);
  }
};

using Twins = testing::Types<timeline, rtl_timeline>;

}  // namespace racebeam
