// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/begun_folder.h"

#include <filesystem>

#include "tb/base/errors.h"
#include "tb/sweep/sweep_kinds.h"

namespace racebeam {

BegunFolder::BegunFolder(const std::string& path) : SweepFolder(path, Access::Read) {
  std::error_code ignored;
  if (!std::filesystem::exists(store(), ignored))
    throw UsageError(path +
                     " is not the folder of a sweep: it has no sweep.sqlite; racebeam "
                     "sweep run FILE.toml -o " +
                     path + " makes one");
}

std::int64_t shown_model(Store& store) {
  std::int64_t model = 0;
  for (const StoredModel& one : store.models()) {
    model = one.id;
    if (engine_of_model(one.hash)) break;
  }
  return model;
}

}  // namespace racebeam
