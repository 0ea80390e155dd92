// How a pixel of the block renderer is explained: a row of explainers().
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/explain/explainers.h"

namespace racebeam {

/// Explainer::size.
Explainer::Size block_size_of(const Run& run, int picture);

/// Explainer::text and json: its block, which core drew it and when, and what each pass met, with
/// the clocks of all states, whose sum is the pixel's. Schema racebeam-explain-block 1.
std::string block_explain_text(const Run& run, const ExplainedPixel& pixel,
                               const std::string& repeat);
std::string block_explain_json(const Run& run, const ExplainedPixel& pixel,
                               const std::string& repeat);

}  // namespace racebeam
