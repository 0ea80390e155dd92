// Explanation: a pixel of the picture, and what of its line's story made it so.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/explain/line_story.h"
#include "tb/show/show.h"

namespace racebeam {

/// How a pixel came to be known, or not.
enum class PixelFate {
  InTime,   ///< the FIFO had its interval before it was shown
  Late,     ///< the beam was here first: it showed what stood last in the FIFO
  Never,    ///< the line ended before the tracer came here
  Column0,  ///< the FIFO's own pixel
  Pattern,  ///< the ray itself is shown, not what it hits
};
/// "in_time", "late", "never", "column_0", "pattern".
const char* fate_name(PixelFate fate);

struct Explanation {
  /// Column 0..639 and row 0..479 of the picture. Runs the chip from the start of the frame.
  Explanation(const Show& show, const knobs& k, int frame, int column, int row);
  /// From the story of the row's line.
  Explanation(const Show& show, LineStory story, int column);
  Explanation(const Explanation&) = delete;  // points into itself
  Explanation& operator=(const Explanation&) = delete;

  const Show& show;
  const LineStory story;
  const int column;
  PixelFate fate;
  const TracedInterval* interval;  ///< of the pixel; nullptr in Column0 and Pattern
  /// Late, Never: the last one that the FIFO had when the pixel was shown; nullptr if none.
  const TracedInterval* before = nullptr;

  int pixel() const { return column - 1; }
  int row() const { return story.y - FirstVisibleLine; }
  const ShownColumn& shown() const { return story.columns[column]; }
  /// Clocks from the one in which the pixel was known to the one in which it was sampled; 0 or
  /// less: the beam won. For known intervals.
  int slack() const { return shown().clock - interval->clock; }
  /// Clocks of the line, first and last, in which this pixel was made and shown.
  int first_clock() const;
  int last_clock() const;
  /// "24", or in a scene file "24 'hall'".
  std::string room(int id) const;
  /// The id in the scene file; empty in the demo.
  std::string room_name(int id) const;
  /// Why the pixel has the colour index that it has, in a sentence.
  std::string why_index() const;
  /// Why the pixel was not known when it was shown, in a sentence; empty for InTime.
  std::string why_unknown() const;

 private:
  bool still_offered() const;  // when the line ended
};

/// "racebeam trace SCENE --from F:L:C --to F:L:C -o pixel.vcd".
std::string trace_command(const Explanation& e, const std::string& repeat);

}  // namespace racebeam
