// PictureChain: pictures of a frame that lead from the chip as it is run to what is meant, each
// with one limit less.
//
// A pixel that differs between the ends of a chain is put down to the last link that changes it, so
// that the counts add up to the difference.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tb/judge/error_links.h"
#include "tb/judge/tlm_pictures.h"

namespace racebeam {

class PictureChain {
 public:
  /// Begins with the chip of these knobs, at the tlm level; `show` must outlive it.
  PictureChain(const Show& show, int frame, const knobs& k);

  /// The next pictures, one a link. A link that changes no knob costs nothing.
  void lift(const std::vector<ErrorLink>& links);
  /// The next picture.
  void add(GoldenPicture picture) { pictures_.push_back(std::move(picture)); }

  /// So many there are, links + 1.
  std::size_t size() const { return pictures_.size(); }
  const GoldenPicture& first() const { return pictures_.front(); }
  const GoldenPicture& last() const { return pictures_.back(); }
  /// For each link from a picture on: the pixels that differ between that picture and the last one,
  /// and change in this link for the last time.
  std::vector<int> last_changes(std::size_t from = 0) const;

 private:
  const TlmPictures tlm_;
  const knobs standard_;
  knobs lifted_;
  bool residue_ = true;  // in the pictures to come
  std::vector<GoldenPicture> pictures_;
};

}  // namespace racebeam
