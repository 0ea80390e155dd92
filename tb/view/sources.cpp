// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/sources.h"

#include <fmt/format.h>

#include <algorithm>

#include "tb/base/errors.h"
#include "tb/view/beam_sources.h"
#include "tb/view/block_source.h"
#include "tb/view/sphere_source.h"
#include "tb/view/voxel_source.h"

namespace racebeam {

const std::vector<SourceKind>& sources() {
  static const std::vector<SourceKind> table = {beam_sources(), sphere_sources(), block_sources(),
                                                voxel_sources()};
  return table;
}

const SourceKind& source_of(const engine& built, const std::string& level) {
  for (const SourceKind& kind : sources()) {
    if (&kind.engine != &built) continue;
    if (std::find(kind.levels.begin(), kind.levels.end(), level) != kind.levels.end()) return kind;
    throw UsageError(fmt::format("view shows {} with --level {}; leave --level and --use out",
                                 built.name, kind.levels.front()));
  }
  throw UsageError(fmt::format("there is no view of {} yet", built.name));
}

}  // namespace racebeam
