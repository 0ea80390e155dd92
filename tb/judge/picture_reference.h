// What pictures are compared with.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace racebeam {

/// The golden tracers, or the base point's own chip.
enum class PictureReference { Geometry, Trace4, Base };

/// By PictureReference: "geometry", "trace4", "base".
const std::vector<std::string>& picture_reference_names();

}  // namespace racebeam
