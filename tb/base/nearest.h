// Finds what somebody meant by a name that does not exist.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/base/errors.h"

namespace racebeam {

/// The known name that begins with `name` or holds it, or else the one that needs the fewest edits;
/// empty if none is close or none is known.
std::string nearest(const std::string& name, const std::vector<std::string>& known);

/// "unknown KIND 'NAME'; did you mean 'NEAREST'?" followed by all known names.
UsageError unknown_name(const std::string& kind, const std::string& name,
                        const std::vector<std::string>& known);

}  // namespace racebeam
