// Reference pictures: what a frame should look like, whatever the knobs of the chip that is judged.
//
// By a golden tracer they have reference knobs: limits at their widest (rooms to the greatest
// depth, corners of any size) and everything else as on the taped-out chip; by the base point they
// are its chip's. Either has the look of the point that is judged, interlace, dithering and
// camera_cosine, which changes what is meant and not how well it is drawn. So few pictures serve
// all points of a sweep.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/golden/golden_picture.h"
#include "tb/judge/picture_reference.h"
#include "tb/show/show.h"

namespace racebeam {

class ReferencePicture {
 public:
  /// Of the frames of a show, for a point with the knobs `k`; `base` are the base point's. Both fit
  /// the show, which must outlive it.
  ReferencePicture(const Show& show, PictureReference reference, const knobs& k, const knobs& base);

  /// What it is made with.
  const knobs& made_with() const { return knobs_; }
  /// Tells its pictures from those of other references of the show: tracer and knobs. Whoever keeps
  /// pictures adds what tells scenes, frames and versions of the model apart.
  std::string key() const;
  /// One byte a pixel. Takes as long as several frames of the chip.
  GoldenPicture picture(int frame) const;

 private:
  const Show& show_;
  const PictureReference reference_;
  const knobs knobs_;
};

}  // namespace racebeam
