// Switches and keys of a board, as somebody sets them beside what the scene does.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace racebeam {

struct BoardPins {
  int switches = 0;  ///< that are turned over, by bit
  int keys = 0;      ///< that are pressed, by bit

  bool operator==(const BoardPins& o) const { return switches == o.switches && keys == o.keys; }
  bool operator!=(const BoardPins& o) const { return !(*this == o); }
};

}  // namespace racebeam
