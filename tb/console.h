// Results on stdout, messages on stderr.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace racebeam {

/// Writes results at once. Throws OutputError, as on a full disk; ClosedPipe if the reader is gone.
void print(std::string_view text);

/// One line for the user, on stderr, after "racebeam: ".
void tell(std::string_view text);

}  // namespace racebeam
