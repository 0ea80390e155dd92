// What a plug-in knows of the source of its RTL.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>
#include <vector>

#include "sc/swap/rtl_model.h"

namespace racebeam {

/// The rest of the remarks of a kind, such as "mine.sv:7 NAME", each once; their files as seen from
/// the working folder where that is shorter.
std::vector<std::string> remarks_of(const rtl_model& model, const std::string& kind);

/// The same in a line, with commas between; of many only the first ones.
std::string remarks_text(const rtl_model& model, const std::string& kind);

/// Inputs that reach no output before the next edge, as far as is known.
std::set<std::string> quiet_inputs_of(const rtl_model& model);

/// Throws RtlFault: an output moved with such an input alone.
[[noreturn]] void tell_not_quiet(const rtl_model& model, const std::string& output);

/// `path` as seen from the working folder, if that is shorter.
std::string nearer_path(const std::string& path);

}  // namespace racebeam
