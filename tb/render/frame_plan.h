// FramePlan: which frames are rendered, in their order.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace racebeam {

class FramePlan {
 public:
  /// `count` frames: `first`, and every `every`-th after it; a show of `show` frames goes round.
  FramePlan(int count, int first, int every, int show);
  /// Those of "7223" or "5,700-720,3900", each once, in that order; of a show of `show` frames.
  /// Throws UsageError.
  FramePlan(const std::string& list, int show);

  int count() const { return count_; }
  int first() const { return number(0); }
  /// Of the `index`-th frame.
  int number(int index) const;
  /// Frames from one to the next; 0: they are a list.
  int every() const { return every_; }
  /// All frames from first() on, without going round.
  bool consecutive() const;
  /// The show ends before the last one.
  bool goes_round() const;

 private:
  int count_, first_, every_, show_;
  std::vector<int> list_;
};

}  // namespace racebeam
