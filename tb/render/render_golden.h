// `racebeam render --golden TRACER`: the frames of a golden tracer, without a chip.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/render/render_options.h"

namespace racebeam {

/// Renders and writes the plan's frames with its tracer. Returns the exit code as command_render
/// does. Throws OutputError.
int render_golden(const RenderPlan& plan);

}  // namespace racebeam
