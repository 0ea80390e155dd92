// What stands in the units' places, for the manifest.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "sc/base/unit_choices.h"
#include "tb/report/manifest.h"

namespace racebeam {

/// Those that are not models, with checksums of the user's files. `uses`: what --use said, such as
/// "stacks=rtl,scene=lockstep:a.sv+b.sv". Throws UsageError.
std::map<std::string, ManifestUnit> unit_files(const unit_choices& units,
                                               const std::vector<std::string>& uses);

}  // namespace racebeam
