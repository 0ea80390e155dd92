// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/tlm_pictures.h"

#include <algorithm>
#include <optional>

#include "sc/beam/tlm/chip_lines.h"
#include "tb/judge/error_links.h"

namespace racebeam {

namespace {

constexpr int AxisZ = 2;

chip_core at_frame(const Show& show, int frame, const knobs& k) {
  chip_core chip(show.program());
  chip.deposit(frame, k);
  return chip;
}

/// What the scene asks for in the chip's frame, where dr2 asks for the pattern or not.
sequencer_outputs choice(const chip_core& chip, const knobs& k, bool shows_pattern = false) {
  const int dr2_y = shows_pattern ? rescaled(1 << 6, DrBits, k.dr_bits) : 0;
  const sequencer_inputs in{true, false, true, dr2_y};
  return chip.program ? chip.timeline.comb(in, *chip.program, k) : chip.sequencer.comb(in, k);
}

/// Tells lines of a run that come out the same with other knobs, clock for clock.
class SameLines {
 public:
  SameLines(const TlmPictures::Run& run, const knobs& k, bool residue, bool interlaced)
      : run_(run), residue_(residue == run.residue || !interlaced) {
    // A stack that lacked nothing may be deeper, and so may a way that came to no end.
    knobs deeper = run.k;
    if (deeper.interval_stack_depth < k.interval_stack_depth)
      deeper.interval_stack_depth = k.interval_stack_depth;
    same_ = deeper == k;
    deeper.max_room_depth = k.max_room_depth;
    deeper.face_stack_depth = k.face_stack_depth;
    further_ = deeper == k && run.k.room_depth_limit() <= k.room_depth_limit();
  }

  /// A visible line, 0..479. Where the stack lacked something the lines before it may show.
  bool has(std::size_t row) const {
    const TlmPictures::Run::Line& line = run_.lines[row];
    const bool odd = (FirstVisibleLine + static_cast<int>(row)) & 1;
    return !line.restarts && (same_ || (further_ && !line.deepest)) && (residue_ || !odd);
  }

 private:
  const TlmPictures::Run& run_;
  const bool residue_;
  bool same_, further_;
};

}  // namespace

TlmPictures::TlmPictures(const Show& show, int frame, const knobs& k)
    : show_(show), start_(at_frame(show, frame, k)) {}

// Lines may be traced apart, and left out, where nothing of a line shows in a later one: it never
// does but where the stack underflows (contract 18, item S), and in the ray pattern.
TlmPictures::Run TlmPictures::run(const knobs& k, bool residue, const Run* before) const {
  const bool pattern = choice(start_, k).lock || choice(start_, k, true).lock;
  if (!pattern && k.interval_stack_depth == most(&knobs::interval_stack_depth)) {
    Run run = trace(k, residue, before, true);
    const auto lacks = [](const Run::Line& line) { return line.restarts; };
    if (std::none_of(run.lines.begin(), run.lines.end(), lacks)) return run;
  }
  return trace(k, residue, nullptr, false);
}

TlmPictures::Run TlmPictures::trace(const knobs& k, bool residue, const Run* before,
                                    bool apart) const {
  const bool interlaced = k.interlace && choice(start_, k).scene_interlace;
  knobs plain = k;
  if (!residue) plain.interlace = 0;
  const int step_back = !residue && interlaced;
  std::optional<SameLines> same;
  if (before) same.emplace(*before, k, residue, interlaced);
  chip_lines chip({plain, show_.program(), false, false, nullptr, apart});
  chip_core& registers = chip.registers();
  registers.sequencer = start_.sequencer;
  registers.timeline = start_.timeline;
  registers.navigator.position_q = start_.navigator.position_q;
  registers.navigator.room_q = start_.navigator.room_q;
  Run run{k, residue, {}, {}};
  run.picture.reserve(VisibleColumns * VisibleRows);
  // The word of the face stack that is written when a room at the greatest depth is entered, and
  // read only behind that.
  constexpr int Unwritten = -1;
  int& last_face = registers.stacks.faces_q[k.room_depth_limit() - 1];
  const auto run_line = [&] {
    registers.navigator.position_q[AxisZ] =
        start_.navigator.position_q[AxisZ] + (chip.next_line() & 1) * step_back;
    chip.run_line();
  };
  run_line();  // in which the frame begins
  while (!apart && chip.next_line() < FirstVisibleLine) run_line();
  for (std::size_t row = 0; row < VisibleRows; ++row) {
    if (same && same->has(row)) {
      const auto from = before->picture.begin() + static_cast<std::ptrdiff_t>(row) * VisibleColumns;
      run.picture.insert(run.picture.end(), from, from + VisibleColumns);
      run.lines.push_back(before->lines[row]);
      continue;
    }
    if (apart) {
      registers.vga_timing.v_pos_q = FirstVisibleLine + static_cast<int>(row);
      registers.vga_timing.v_region_q = 1;
    }
    last_face = Unwritten;
    run_line();
    run.picture.insert(run.picture.end(), chip.pixels().begin(), chip.pixels().end());
    run.lines.push_back({chip.take_stats().restarts > 0, last_face != Unwritten});
    ++run.traced;
  }
  return run;
}

}  // namespace racebeam
