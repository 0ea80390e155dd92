// Plug-ins of verilated RTL, in a cache by content.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/verilate/rtl_sources.h"

namespace racebeam {

/// The path of the plug-in of `sources`, verilated when first needed: again whenever a file of it,
/// an include, an option, Verilator or the glue is another. Of several processes that need the same
/// one makes it. A line on stderr says what takes the time. Throws RtlError with what Verilator or
/// the compiler says, or why the cache cannot be written; MissingTool, Interrupted.
std::string rtl_plugin(const RtlSources& sources);

}  // namespace racebeam
