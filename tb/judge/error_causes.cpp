// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/error_causes.h"

#include "tb/judge/picture_chain.h"

namespace racebeam {

namespace {

/// The links that knobs make, and what is left between the last of them and the reference.
struct Way {
  const std::vector<ErrorLink>& links;
  ErrorCause rest;

  std::vector<ErrorCause> causes() const {
    std::vector<ErrorCause> all;
    for (const ErrorLink& link : links) all.push_back(link.cause);
    all.push_back(rest);
    return all;
  }
};

const Way& way_to(PictureReference reference) {
  static const Way geometry = {reference_geometry_links(),
                               {"ray_rest", "the camera's products; corners too far off"}};
  static const Way trace_4 = {
      reference_trace_4_links(),
      {"corner_wrap", "a corner too far for its register counts as behind the camera"}};
  return reference == PictureReference::Trace4 ? trace_4 : geometry;
}

}  // namespace

const std::vector<ErrorCause>& error_causes(PictureReference reference) {
  static const std::vector<ErrorCause> geometry = way_to(PictureReference::Geometry).causes();
  static const std::vector<ErrorCause> trace_4 = way_to(PictureReference::Trace4).causes();
  return reference == PictureReference::Trace4 ? trace_4 : geometry;
}

std::vector<int> errors_by_cause(const Show& show, int frame, const knobs& k,
                                 PictureReference reference, const GoldenPicture& picture) {
  PictureChain chain(show, frame, k);
  chain.lift(way_to(reference).links);
  chain.add(reference == PictureReference::Base
                ? ReferencePicture(show, PictureReference::Geometry, k, k).picture(frame)
                : picture);
  return chain.last_changes();
}

}  // namespace racebeam
