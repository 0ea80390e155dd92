// The knobs as RTL knows them: parameters of a unit's module.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "sc/base/knobs.h"
#include "sc/swap/rtl_library.h"

namespace racebeam {

/// One knob as a parameter.
struct rtl_parameter {
  std::string name;  ///< "IntervalStackDepth"
  std::string knob;  ///< "interval_stack_depth"
  int value;
};

/// All of them, with what `k` sets.
std::vector<rtl_parameter> rtl_parameters(const knobs& k);

/// Those that RTL was built with, by name, and `k` wants otherwise.
std::vector<rtl_parameter> other_parameters(const std::map<std::string, int>& built,
                                            const knobs& k);
/// The parameters of a plug-in.
std::map<std::string, int> built_parameters(const rtl_model& model);

}  // namespace racebeam
