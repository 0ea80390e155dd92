// Parameters of a unit's RTL: what it was built with, and what a chip wants.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "sc/swap/rtl_library.h"

namespace racebeam {

/// What a parameter shall be, in RTL that has it.
struct rtl_parameter {
  std::string name;  ///< "IntervalStackDepth"
  std::int64_t value;
  std::string what;        ///< it stands for: "the knob interval_stack_depth"
  std::string model_of{};  ///< the unit whose RTL cannot have this value
};

/// Those that RTL was built with, by name, otherwise than `wanted`.
std::vector<rtl_parameter> other_parameters(const std::map<std::string, std::int64_t>& built,
                                            const std::vector<rtl_parameter>& wanted);
/// The parameters of a plug-in; those that are texts as 0.
std::map<std::string, std::int64_t> built_parameters(const rtl_model& model);

}  // namespace racebeam
