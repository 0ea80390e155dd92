// The sheet of a comparison: what each engine draws and should, and what it hits and should.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/picture/rgb_image.h"
#include "tb/report/comparison.h"

namespace racebeam {

/// The chip's picture dimmed, with pixels that differ from the ideal one bright: the more, the
/// brighter. Throws std::invalid_argument if their sizes are not the same.
RgbImage difference_picture(const VgaFrame& picture, const VgaFrame& ideal);

/// A row for each engine that draws: picture, golden, hits, golden's hits, at half size.
RgbImage compare_sheet(const std::vector<ComparedGroup>& groups);

}  // namespace racebeam
