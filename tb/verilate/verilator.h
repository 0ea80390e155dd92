// Verilator: all that the program relies on of it, but its XML (rtl_syntax.cpp) and the classes
// that sc/swap/rtl_glue.cc.in includes. Tried with the version TriedVerilator.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tb/verilate/rtl_sources.h"

namespace racebeam {

constexpr const char* TriedVerilator = "5.006";

/// What `verilator --version` says. Throws MissingTool, with the package to install.
const std::string& verilator_version();

/// The folder of Verilator's run time: verilated.h, verilated.cpp and what they include.
std::string verilator_runtime();

/// The folders in which Verilator looks for includes and modules, as absolute paths.
std::vector<std::string> searched_folders(const RtlSources& sources);
/// The same sources and settings as Verilator's options.
std::vector<std::string> source_words(const RtlSources& sources);

/// Writes the elaborated RTL as XML to the file `xml`; `work` is an empty folder. Throws RtlError
/// with Verilator's messages, Interrupted.
void write_rtl_xml(const RtlSources& sources, const std::string& work, const std::string& xml);

/// Writes the C++ class Vrtl of the RTL into the folder `work`, `split` into small functions or in
/// large ones, which are faster; returns Verilator's messages. Throws as write_rtl_xml().
std::string write_rtl_classes(const RtlSources& sources, const std::string& work, bool split,
                              const std::function<void()>& tick);

/// Signals of circular logic among Verilator's messages, as "FILE:LINE NAME".
std::vector<std::string> circular_signals(const std::string& messages);

}  // namespace racebeam
