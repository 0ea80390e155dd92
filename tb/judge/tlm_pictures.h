// TlmPictures: a frame by chips of any knobs at the tlm level, without SystemC: as many in a
// process as are wanted.
//
// The lines of chip_lines, pixel for pixel what the wired chip shows. The camera flies to the frame
// once, not once a picture.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/beam/chip_core.h"
#include "tb/golden/golden_picture.h"
#include "tb/show/show.h"

namespace racebeam {

class TlmPictures {
 public:
  /// A frame of a show, 0..show.frames() - 1, by a chip that starts in reset just before it; `show`
  /// must outlive this. The knobs are those of its camera: of navigator_bits and free_flight.
  TlmPictures(const Show& show, int frame, const knobs& k);

  /// As a chip with these knobs shows it.
  GoldenPicture picture(const knobs& k) const;
  /// The same where the rule of contract 5.4 leaves nothing behind: on odd lines the camera itself
  /// stands one step back.
  GoldenPicture without_residue(const knobs& k) const;

 private:
  GoldenPicture run(const knobs& k, int step_back) const;

  const Show& show_;
  const chip_core start_;  // its frame counter and navigator count
};

}  // namespace racebeam
