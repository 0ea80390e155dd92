// What tells the model of an engine from others, as it was built.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace racebeam {

/// XXH3 of 128 bits over the sources that can change a result of this engine, as 32 digits; the
/// list is in cmake/model_hash.cmake. Throws std::invalid_argument if it has no such engine.
std::string model_hash(const std::string& engine);

}  // namespace racebeam
