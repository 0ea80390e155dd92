// Which points of a sweep are worth having: on the front of its goals, surely dominated, undecided.
//
// Points are compared in pairs on the frames that both have. A point surely dominates another if it
// is no worse in every exact goal and surely better in every sampled one. Surely: the end of the
// interval of the difference says so, and intervals are so wide that for all its rivals together
// the chance of a point to be called dominated though it is not is small. Its rivals are the points
// that are no worse in exact goals; no other can dominate it. Once all frames are taken, figures of
// frames are exact as well. A point dominates the other's mean if it is no worse in any goal and
// better in one.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/sweep/goal.h"
#include "tb/sweep/interval.h"

namespace racebeam {

/// What is known of a goal's figure for a point.
struct Reading {
  enum Kind { Sampled, Largest, Exact };

  Kind kind = Exact;
  double exact = 0;
  Strata frames;  ///< of figures of frames
};

struct Candidate {
  std::string name;
  std::vector<Reading> readings;  ///< by goal; all points have the same kinds and the same scenes
  bool base = false;              ///< what all are compared with: racing never stops it
  bool stopped = false;           ///< by racing: a rival of others, but neither is compared
};

struct Verdict {
  enum Standing {
    Front,      ///< within the limits, and nothing dominates its mean
    Dominated,  ///< surely, by candidate `by`; it is as surely within the limits, or no worse there
    Undecided,
    Unwanted,  ///< surely beyond a limit of goal `by`
  };
  Standing standing = Undecided;
  int by = -1;
};

/// By candidate; each has at least one frame of every scene, unless it is stopped: it stays
/// Undecided. `confidence`: that a point is not called dominated, or beyond a limit, by chance.
std::vector<Verdict> judge(const std::vector<Candidate>& candidates, const std::vector<Goal>& goals,
                           double confidence);

}  // namespace racebeam
