// What a worker of a sweep does: it renders the frames of a block, and says what it has counted.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace racebeam {

/// Writes an answer for each frame of the request to the file, then the line after the last; an
/// error line if it cannot. What it and the libraries that it calls say on stderr goes there, too.
void work_on(const std::string& request, int file);

}  // namespace racebeam
