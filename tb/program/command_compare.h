// `racebeam compare`: engines side by side, on scenes of their own and common ones.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/program/command.h"

namespace racebeam {

struct CompareOptions {
  std::vector<std::string> scenes, engines, assignments;
  long long pictures = 1;
  std::string folder, markdown, sheet, expect;
  bool json = false;
};

int command_compare(const CompareOptions& options);

Command compare_row();

}  // namespace racebeam
