// What every `racebeam view` makes of its options: keys, the viewer's own options, the screen.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tb/program/command_view.h"
#include "tb/view/view_screen.h"

namespace racebeam {

/// The keys of --keys, for such a chip. Throws UsageError for one that does nothing.
std::vector<std::string> keys_to_press(const ViewOptions& options, KeyHelp::Chip chip);

/// For a show of so many frames. Throws UsageError.
Viewer::Options viewer_options(const ViewOptions& options, int frames);

/// A window or a terminal. Throws UsageError, MissingTool.
std::unique_ptr<ViewScreen> open_screen(const ViewOptions& options);

}  // namespace racebeam
