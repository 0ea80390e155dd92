// The viewer's window, of the WindowLibrary.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "tb/view/view_screen.h"

namespace racebeam {

/// Opens the window and the loudspeaker; without a loudspeaker it says so and is silent. `scale`
/// is the size of a pixel, 0: as large as fits well. Throws MissingTool.
std::unique_ptr<ViewScreen> open_window(int scale);

}  // namespace racebeam
