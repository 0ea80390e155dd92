// Errors by cause: why a frame of a point differs from its reference picture.
//
// As golden_compare, but to a picture that does not move with the knobs: a chain of pictures, each
// with one limit less, at the tlm level. A pixel that differs is put down to the last link that
// changes it, so the numbers add up to the difference.
//
// The further down a chain, the less of a point is left: chains of points come together. What a
// link brings is kept as the pixels that it changes for the last time, and found again by what they
// depend on, so no link is rendered for two points.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/judge/error_links.h"
#include "tb/judge/reference_picture.h"
#include "tb/judge/tlm_pictures.h"

namespace racebeam {

/// All causes, in the order in which they are lifted, on the way to `reference`. The base point's
/// chip is no ideal: for it they are those of geometry.
const std::vector<ErrorCause>& error_causes(PictureReference reference);

/// The way of a point from its own picture to the one that is meant. Needs no SystemC: any process
/// may ask, for any points.
class ErrorChain {
 public:
  /// `show` must outlive it.
  ErrorChain(const Show& show, const knobs& k, PictureReference reference);

  /// What the chain ends in: `reference`, or geometry's picture instead of the base's.
  const ReferencePicture& end() const { return end_; }

  /// What each picture between the point's own and the end depends on, beside scene and frame.
  const std::vector<std::string>& keys() const { return keys_; }
  /// By key: the pixels for which the picture is the last one that differs from the end, a bit
  /// each; "": not known.
  using Links = std::vector<std::string>;

  /// Pixels of a frame that differ between the point's own picture and that of end(), by
  /// error_causes(). Links that are not known are rendered and put there.
  std::vector<int> by_cause(int frame, const GoldenPicture& own, const GoldenPicture& end,
                            Links& links) const;

 private:
  /// A picture, and the cause that is lifted behind it.
  struct Step {
    knobs k;
    bool residue;  ///< of the interlace is in it
    std::size_t cause;
  };

  /// Calls act(step, picture) for each link that is not known, in order.
  template <class Do>
  void render_links(int frame, const Links& links, const Do& act) const;

  const Show& show_;
  const PictureReference reference_;
  const ReferencePicture end_;
  std::vector<Step> steps_;  // the first: the point's own
  std::vector<std::string> keys_;
};

}  // namespace racebeam
