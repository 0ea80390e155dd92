// The files of tb/report/page, which are built into the program.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace racebeam {

/// "report.css", "vega/vega.min.js": the file as it was when the program was built. Throws
/// std::out_of_range of other names.
std::string_view page_file(const std::string& name);

}  // namespace racebeam
