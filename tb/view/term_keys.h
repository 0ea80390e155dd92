// TermKeys: what a terminal sends when keys are pressed, as the names of those keys.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace racebeam {

/// The keys of some bytes that came at once; an escape that begins no known sequence is the key
/// itself. Letters are small.
std::vector<std::string> term_keys(std::string_view bytes);

}  // namespace racebeam
