// The keys of a sweep file, each documented once: what the reader accepts. Tables whose keys are
// names of knobs or figures are not here, but for what else they take.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tb/scene/scene_keys.h"

namespace racebeam {

/// All of them, in the order of a page.
const std::vector<FileKey>& sweep_keys();

}  // namespace racebeam
