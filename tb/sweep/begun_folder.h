// BegunFolder: the folder of a sweep that has begun, to read it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "tb/sweep/store.h"
#include "tb/sweep/sweep_folder.h"

namespace racebeam {

struct BegunFolder : SweepFolder {
  /// Throws UsageError if nothing has been stored there.
  explicit BegunFolder(const std::string& path);
};

/// Whose results are shown: a model of this program, or else the last one; 0: there is none yet.
std::int64_t shown_model(Store& store);

}  // namespace racebeam
