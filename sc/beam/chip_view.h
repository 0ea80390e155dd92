// chip_view: the wires of one clock that a bench looks at, settled, as plain numbers.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>

namespace racebeam {

struct chip_view {
  int y, frame;
  bool line_end, consume, run;
  int state, idx2, i2, tag, sd;
  bool second, wall, emit, ack, line_done, restart, starving, descend, push;
  int fill, dec, mask, value;
  bool lock;

  bool operator==(const chip_view& other) const {
    const auto all = [](const chip_view& v) {
      return std::tie(v.y, v.frame, v.line_end, v.consume, v.run, v.state, v.idx2, v.i2, v.tag,
                      v.sd, v.second, v.wall, v.emit, v.ack, v.line_done, v.restart, v.starving,
                      v.descend, v.push, v.fill, v.dec, v.mask, v.value, v.lock);
    };
    return all(*this) == all(other);
  }
};

}  // namespace racebeam
