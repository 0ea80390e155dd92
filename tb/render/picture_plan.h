// Where the pictures of a render go, and as what.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/render/render_options.h"

namespace racebeam {

/// Sets folder, picture and format of a plan that has all else: "-o NAME.exr" is one picture, any
/// other name a folder, also of pictures if such a folder is there. Throws UsageError.
void plan_pictures(OutputPlan& plan, const RenderOptions& options);

}  // namespace racebeam
