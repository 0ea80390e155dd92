// Why a pixel of the sphere tracer is as it is: the states in which it was drawn, with their
// clocks, objects and outcomes, and the colour after each ADD: a row of explainers().
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/explain/explainers.h"

namespace racebeam {

Explainer::Size sphere_size(const Run& run, int picture);

/// Some aligned lines, and a table of the states.
std::string sphere_explain_text(const Run& run, const ExplainedPixel& pixel,
                                const std::string& repeat);
/// Schema "racebeam-explain-sphere" version 1: what the text says, with the knobs.
std::string sphere_explain_json(const Run& run, const ExplainedPixel& pixel,
                                const std::string& repeat);

}  // namespace racebeam
