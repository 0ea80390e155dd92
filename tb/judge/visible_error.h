// How much of a difference between two pictures an eye would see: edges that lie one pixel off do
// not count.
//
// A pixel is visibly wrong if it differs and no movement by one pixel explains it: its colour is
// not near in the reference, or the reference's colour is not near in the picture. The first finds
// what should not be there, the second what is lost. Near is the 3 x 3 neighbourhood. Dithering and
// interlace show other colours on every other line; so a colour two lines up or down, at most one
// column aside, is near as well where the line between is right there.
//
// So an edge moved by one pixel, also aslant, counts nothing, one moved by two pixels counts both;
// a hole counts, and a line of one pixel that is lost, that is too much, or that lies two pixels
// off. A pixel that some other edge of its colour passes by chance is forgiven: it is a lower
// bound.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/golden/golden_picture.h"

namespace racebeam {

/// Pixels of two pictures that are visibly different. It does not matter which is the reference.
int visible_difference(const GoldenPicture& a, const GoldenPicture& b);

}  // namespace racebeam
