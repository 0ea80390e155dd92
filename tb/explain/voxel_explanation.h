// How a pixel of the voxel tracer is explained: a row of explainers().
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/explain/explainers.h"

namespace racebeam {

/// Explainer::size.
Explainer::Size voxel_size_of(const Run& run, int picture);

/// Explainer::text and json: how its ray, and the one to the light, went through the octree, and
/// the clocks of all states, whose sum is the pixel's. Schema racebeam-explain-voxel 1.
std::string voxel_explain_text(const Run& run, const ExplainedPixel& pixel,
                               const std::string& repeat);
std::string voxel_explain_json(const Run& run, const ExplainedPixel& pixel,
                               const std::string& repeat);

}  // namespace racebeam
