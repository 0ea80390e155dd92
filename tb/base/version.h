// The program's version, from the build.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace racebeam {

/// "0.2.0"
const char* program_version();

}  // namespace racebeam
