// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/tlm_pictures.h"

#include "sc/beam/tlm/chip_lines.h"

namespace racebeam {

namespace {

constexpr int AxisZ = 2;

chip_core at_frame(const Show& show, int frame, const knobs& k) {
  chip_core chip(show.program());
  chip.deposit(frame, k);
  return chip;
}

/// Whether the scene asks for interlace in the chip's frame.
bool interlaced(const chip_core& chip, const knobs& k) {
  const sequencer_inputs in{true, false, true, 0};
  return (chip.program ? chip.timeline.comb(in, *chip.program, k) : chip.sequencer.comb(in, k))
      .scene_interlace;
}

}  // namespace

TlmPictures::TlmPictures(const Show& show, int frame, const knobs& k)
    : show_(show), start_(at_frame(show, frame, k)) {}

GoldenPicture TlmPictures::picture(const knobs& k) const { return run(k, 0); }

GoldenPicture TlmPictures::without_residue(const knobs& k) const {
  knobs plain = k;
  plain.interlace = 0;
  return run(plain, k.interlace && interlaced(start_, k));
}

GoldenPicture TlmPictures::run(const knobs& k, int step_back) const {
  chip_lines chip({k, show_.program()});
  chip_core& registers = chip.registers();
  registers.sequencer = start_.sequencer;
  registers.timeline = start_.timeline;
  registers.navigator.position_q = start_.navigator.position_q;
  registers.navigator.room_q = start_.navigator.room_q;
  GoldenPicture picture;
  picture.reserve(VisibleColumns * VisibleRows);
  while (chip.next_line() < FirstVisibleLine + VisibleRows) {
    registers.navigator.position_q[AxisZ] =
        start_.navigator.position_q[AxisZ] + (chip.next_line() & 1) * step_back;
    chip.run_line();
    if (chip.visible()) picture.insert(picture.end(), chip.pixels().begin(), chip.pixels().end());
  }
  return picture;
}

}  // namespace racebeam
