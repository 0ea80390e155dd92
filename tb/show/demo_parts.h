// The demo's timeline: what is shown when.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace racebeam {

/// One row of the timeline (contract 17.7).
struct DemoPart {
  int first_frame, last_frame;
  int selector;         ///< scene selector e (contract 17.1)
  int variant;          ///< rotation variant (contract 17.3)
  const char* scene;    ///< which rooms
  const char* effects;  ///< what is done to the view; empty if nothing

  /// "tunnel", or "pillars, fov sweep".
  std::string name() const;
};

/// All parts, in order, frames 0..12798 without a gap.
const std::vector<DemoPart>& demo_parts();

/// The part that shows a frame, 0..12798. Throws std::out_of_range.
const DemoPart& demo_part(int frame);

}  // namespace racebeam
