// RTL as Verilator's XML, in the cache.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/verilate/rtl_sources.h"

namespace racebeam {

struct Elaborated {
  std::string xml;      ///< path of the file
  std::string content;  ///< names settings, Verilator and what all files hold that were read
};

/// What is named is what was read: of files that are saved meanwhile it reads again. Throws
/// RtlError, MissingTool, Interrupted.
Elaborated elaborated(const RtlSources& sources);

}  // namespace racebeam
