// The C++ compiler's part in a plug-in: from Verilator's classes to a shared object.
//
// What is the same in several plug-ins is compiled once and kept in the cache: Verilator's run
// time, the headers that all classes include, and equal classes of RTL that lies elsewhere or
// differs in comments.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "tb/verilate/cache_folder.h"

namespace racebeam {

/// Another one whenever the same classes shall become another plug-in. Throws MissingTool if there
/// is no compiler.
std::string compile_key();

/// The same for what plug-ins that count their coverage have beside.
std::string coverage_key();

/// Compiles the class Vrtl that write_rtl_classes() has written into `work`, with `facts`, macros
/// for sc/swap/rtl_glue.cc.in, and `texts`, the variables that it looks for, and links it to `out`;
/// `coverage`: the class counts its coverage. Throws RtlError with what the compiler says,
/// MissingTool, Interrupted.
void compile_plugin(const WorkFolder& work, const std::string& facts, const std::string& texts,
                    bool coverage, const std::function<void()>& tick, const std::string& out);

}  // namespace racebeam
