// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/base/version.h"

namespace racebeam {

const char* program_version() { return RACEBEAM_VERSION; }

}  // namespace racebeam
