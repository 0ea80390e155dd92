// A memory's contents as a file, for $readmemh.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace racebeam {

/// "file" of the cache that holds `text`, with its quotes. Throws RtlError, Interrupted.
std::string table_file(const std::string& text);

}  // namespace racebeam
