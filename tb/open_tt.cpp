// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/open_tt.h"

#include "tb/plugin_maker.h"

namespace racebeam {

TtProject open_tt_project(const TtOptions& options) { return read_tt_project(options.project); }

std::string tt_plugin(const TtProject& project, bool signals) {
  return make_chip_plugin(project.top, project.sources, signals);
}

}  // namespace racebeam
