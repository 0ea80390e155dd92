// chip_view: the wires of one clock that a bench looks at, settled, as plain numbers.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace racebeam {

struct chip_view {
  int y, frame;
  bool line_end, consume, run;
  int state, idx2, i2, tag, sd;
  bool second, wall, emit, ack, line_done, restart, starving, descend, push;
  int fill;
};

}  // namespace racebeam
