// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/reference_picture.h"

#include <nlohmann/json.hpp>

#include "tb/judge/error_links.h"
#include "tb/judge/tlm_pictures.h"
#include "tb/show/knobs_json.h"

namespace racebeam {

namespace {

knobs reference_knobs(const Show& show, PictureReference reference, const knobs& point,
                      const knobs& base) {
  knobs k = base;
  if (reference != PictureReference::Base) {
    k = show.standard_knobs();
    k.max_room_depth = most(&knobs::max_room_depth);
    k.face_stack_depth = most(&knobs::face_stack_depth);
  }
  k.interlace = point.interlace;
  k.dithering = point.dithering;
  k.camera_cosine = point.camera_cosine;
  return k;
}

}  // namespace

ReferencePicture::ReferencePicture(const Show& show, PictureReference reference, const knobs& k,
                                   const knobs& base)
    : show_(show), reference_(reference), knobs_(reference_knobs(show, reference, k, base)) {}

std::string ReferencePicture::key() const {
  return picture_reference_names()[static_cast<std::size_t>(reference_)] + " " +
         knobs_json(knobs_).dump();
}

GoldenPicture ReferencePicture::picture(int frame) const {
  if (reference_ == PictureReference::Base)
    return TlmPictures(show_, frame, knobs_).picture(knobs_);
  GoldenWorld world = show_.golden_world(frame, knobs_);
  world.corner_bits = 0;
  return golden_picture(
      reference_ == PictureReference::Trace4 ? GoldenTracer::Trace4 : GoldenTracer::Geometry, world,
      show_.golden_camera(frame, knobs_));
}

}  // namespace racebeam
