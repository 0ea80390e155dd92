// rtl_rest: which clocks of verilated RTL can be left out.
//
// A unit that waits has registers that a clock does not change. As long as no input moves, the next
// clock does not change them either. Whether it is so is looked at only when no port has moved, and
// ever more rarely while it is not so.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "sc/swap/rtl_library.h"

namespace racebeam {

class rtl_rest {
 public:
  /// Whether a clock with the inputs of the last one changes nothing.
  bool now() const { return rests_; }
  /// An input has moved.
  void end() {
    rests_ = false;
    still_ = 0;
  }
  /// After each clock; `moved`: an output has, or an input with it.
  void look(const rtl_model& model, bool moved) {
    if (moved || !model.rests) still_ = 0;
    else if (++still_ == wait_) model.rests(model.top);
    else if (still_ > wait_) judge(model);
  }

 private:
  static constexpr int MostWait = 64;

  void judge(const rtl_model& model) {
    rests_ = model.rests(model.top) != 0;
    wait_ = rests_ ? 1 : std::min(MostWait, 2 * wait_);
    still_ = 0;
  }

  bool rests_ = false;
  int still_ = 0;  // clocks without a move
  int wait_ = 1;   // so many, then a look
};

}  // namespace racebeam
