// What a plug-in of verilated RTL counts of its own lines, branches and toggling bits, if it was
// built to.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

extern "C" {
/// The symbol "rtl_write_coverage_1" of such a plug-in: writes the counts of the instance that this
/// thread made last to a file, as Verilator has them; 0 if it could not.
typedef int (*rtl_coverage_writer)(const char* path);
}

namespace racebeam {

/// Writes the counts of the instance of `plugin` that this thread made last, and that still lives.
/// Throws RtlError: it is not loaded, was built without coverage, or the file cannot be written.
void write_rtl_coverage(const std::string& plugin, const std::string& path);

}  // namespace racebeam
