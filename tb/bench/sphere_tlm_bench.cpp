// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/sphere_tlm_bench.h"

#include "tb/bench/sphere_bench.h"
#include "tb/bench/store_pins.h"
#include "tb/host/sphere_words.h"

namespace racebeam {

namespace {

/// The CPU's clocks of a picture: up to the end of HOST, and what it still does after it.
void send(SphereWords words, sphere_core& core) {
  while (!core.host_clock(words.clock())) continue;
  while (!words.sent()) core.busy_clock(words.clock());
}

SphereMotion motion_of(const SphereProgram& program, const sphere_knobs& k) {
  return {program.moving, program.box, k.capture_guard};
}

}  // namespace

SphereTlmBench::SphereTlmBench(const WiredBench::Setting& setting, const BenchWishes& wishes)
    : program_(sphere_program_of(setting.scene)),
      knobs_(sphere_knobs(setting.k).resolved()),
      wishes_(wishes),
      pictures_(setting.frames),
      core_(knobs_, program_, program_.board),
      motion_(motion_of(program_, knobs_)) {}

void SphereTlmBench::seek(int picture) {
  if (picture == next_) return;
  motion_ = motion_of(program_, knobs_);
  for (next_ = 0; next_ < picture; ++next_)
    if (next_ > 0) motion_.picture(program_.inputs_before(next_).rotz_q);
  core_.deposit(program_.inputs_before(picture));
}

ChipBench::Frame SphereTlmBench::render() {
  if (next_ == pictures_) seek(0);
  const sphere_board board = program_.board_in(next_);
  core_.await_frame();
  if (program_.resets(next_)) core_.reset(board);
  if (next_ > 0) motion_.picture(core_.inputs().rotz_q);
  send({motion_.table(), knobs_.host_clocks_per_word}, core_);
  const bool narrow = core_.inputs().narrow_q;
  core_.draw(board);
  const sphere_counters& n = core_.counters();
  const std::vector<std::uint64_t> drawn = words();
  Frame frame{next_,
              sphere_picture(next_, drawn, narrow, knobs_, wishes_),
              counted(n),
              {},
              {n.clocks, n.frames}};
  if (wishes_.crc)
    frame.picture.pins_crc = store_pins_crc(drawn, knobs_.store(), knobs_.clocks_per_pixel);
  ++next_;
  return frame;
}

PixelClocks sphere_pixels(const WiredBench::Setting& setting, int picture) {
  SphereTlmBench bench(setting, {});
  bench.seek(picture);
  PixelClocks pixels{};
  bench.note_pixels(&pixels.begins);
  const ChipBench::Frame frame = bench.render();
  pixels.columns = frame.picture.width;
  pixels.rows = frame.picture.height;
  pixels.begins.push_back(static_cast<std::int64_t>(bench.clocks()));
  return pixels;
}

}  // namespace racebeam
