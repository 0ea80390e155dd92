// How users name the RTL of a unit: FILE, FILE+FILE, LIST.f or a folder.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/verilate/rtl_sources.h"

namespace racebeam {

/// What follows "UNIT=" may be RTL: .sv, .v, .f, a folder, or several of these joined with '+'.
bool is_source_list(const std::string& text);

/// The RTL of `top` that `text` names. A folder stands for its .sv and .v files. A list (.f) has
/// what simulators take: files, -f LIST, -v FILE, -y FOLDER, -I FOLDER, +incdir+FOLDER, -D
/// NAME=VALUE, +define+NAME=VALUE, -G Name=value, +libext+ (without effect), comments; its paths
/// begin at its own folder. Throws UsageError with file and line.
RtlSources read_source_list(const std::string& top, const std::string& text);

/// Files and folders that `text` names, lists inside lists too, and then the files that the RTL of
/// `top` is made of, includes too, if it can be read: what may change.
std::vector<std::string> files_of_list(const std::string& top, const std::string& text);

}  // namespace racebeam
