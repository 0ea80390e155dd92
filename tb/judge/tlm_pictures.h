// TlmPictures: a frame by chips of any knobs at the tlm level, without SystemC: as many in a
// process as are wanted.
//
// The lines of chip_lines, pixel for pixel what the wired chip shows. The camera flies to the frame
// once, not once a picture; and a line of which another picture tells that it comes out the same is
// taken from there.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

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
  GoldenPicture picture(const knobs& k) const { return run(k, true).picture; }
  /// The same where the rule of contract 5.4 leaves nothing behind: on odd lines the camera itself
  /// stands one step back.
  GoldenPicture without_residue(const knobs& k) const { return run(k, false).picture; }

  /// A picture, and what its lines say of pictures by chips with other knobs.
  struct Run {
    struct Line {
      bool restarts;  ///< the interval stack underflowed before line_done
      bool deepest;   ///< a room at the greatest depth was entered
    };
    knobs k;
    bool residue;
    GoldenPicture picture;
    std::vector<Line> lines;
    int traced = 0;  ///< visible lines that were not taken from another run
  };
  /// The same picture, with or without residue. `before` is another run of this, if there is one.
  Run run(const knobs& k, bool residue, const Run* before = nullptr) const;

 private:
  /// With lines `apart` those before a line do not show in it.
  Run trace(const knobs& k, bool residue, const Run* before, bool apart) const;

  const Show& show_;
  const chip_core start_;  // its frame counter and navigator count
};

}  // namespace racebeam
