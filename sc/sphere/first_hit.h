// What the first ray of a pixel meets first, as a number.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/sphere/codes.h"

namespace racebeam {

/// A sphere by its index in the table, the light among them; a plane by FirstPlane + index.
enum sphere_first_hit { EyeInside = -2, MeetsNothing = -1, FirstPlane = 1 << SphereIndexBits };

}  // namespace racebeam
