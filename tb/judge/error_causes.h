// Errors by cause: why a frame of a point differs from its reference picture.
//
// As golden_compare, but to a picture that does not move with the knobs: a chain of pictures, each
// with one limit less, at the tlm level. A pixel that differs is put down to the last link that
// changes it, so the numbers add up to the difference.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tb/judge/error_links.h"
#include "tb/judge/reference_picture.h"

namespace racebeam {

/// All causes, in the order in which they are lifted, on the way to `reference`. The base point's
/// chip is no ideal: for it they are those of geometry.
const std::vector<ErrorCause>& error_causes(PictureReference reference);

/// Pixels of a frame that differ from a reference picture, by error_causes(). `picture` is that of
/// `reference`, which ReferencePicture makes; not used for the base. Needs no SystemC: any process
/// may ask, for any points.
std::vector<int> errors_by_cause(const Show& show, int frame, const knobs& k,
                                 PictureReference reference, const GoldenPicture& picture);

}  // namespace racebeam
