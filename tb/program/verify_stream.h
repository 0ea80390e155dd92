// Streams of one unit alone: a difference is shrunk to one, and one from a file is played.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "tb/program/verify_unit.h"

namespace racebeam {

/// Shrinks what the first `first.clock` clocks of `stimulus` and the one of the difference come
/// down to, and writes FOLDER/<unit>_<traffic>.stream; `verify` is the command that such a file is
/// played with. first.shrunk and first.text say what came of it. Only one such call and nothing
/// else of SystemC may happen in a process. Throws RtlError, OutputError.
void shrink_difference(FirstDifference& first, const UnitUnderTest& dut, Stimulus stimulus,
                       unsigned seed, const std::string& folder, const std::string& verify);

/// Compares model and RTL over the stream of a file; else as verify_unit(). Throws UsageError too.
UnitVerdict verify_stream(const UnitUnderTest& dut, const std::string& file,
                          const std::string& folder, const std::string& repeat);

}  // namespace racebeam
