// The text of a file that somebody wrote: a scene, a sweep.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "tb/scene/faults.h"

namespace racebeam {

/// All of it, or nothing and a fault: no such file, a folder, more than 16 MB. `kind` is what it
/// should hold, "scene"; `racebeam KIND new` writes one.
std::optional<std::string> read_input_file(const std::string& path, const std::string& kind,
                                           Faults& faults);

}  // namespace racebeam
