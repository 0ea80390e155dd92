// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/picture_chain.h"

namespace racebeam {

PictureChain::PictureChain(const Show& show, int frame, const knobs& k)
    : tlm_(show, frame, k),
      standard_(show.standard_knobs()),
      lifted_(k),
      pictures_{tlm_.picture(k)} {}

void PictureChain::lift(const std::vector<ErrorLink>& links) {
  for (const ErrorLink& link : links) {
    const knobs before = lifted_;
    const bool residue_before = residue_;
    if (link.lift) link.lift(lifted_, standard_);
    else residue_ = false;
    if (lifted_ == before && residue_ == residue_before) pictures_.push_back(last());
    else pictures_.push_back(residue_ ? tlm_.picture(lifted_) : tlm_.without_residue(lifted_));
  }
}

std::vector<int> PictureChain::last_changes(std::size_t from) const {
  std::vector<int> counts(pictures_.size() - 1 - from);
  const GoldenPicture &begin = pictures_[from], &end = pictures_.back();
  for (std::size_t pixel = 0; pixel < end.size(); ++pixel) {
    if (begin[pixel] == end[pixel]) continue;
    std::size_t link = pictures_.size() - 1;
    while (pictures_[link - 1][pixel] == end[pixel]) --link;
    ++counts[link - 1 - from];
  }
  return counts;
}

}  // namespace racebeam
