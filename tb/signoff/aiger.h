// Circuits of AND gates and registers in the binary format of AIGER, as yosys writes them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <string>

namespace racebeam {

/// The same circuit, where some inputs, by their numbers from 0, are constants for whatever reads
/// them; they stay in the list of inputs. Of properties it may have outputs only. Throws RtlError
/// if it is no such circuit.
std::string with_constant_inputs(const std::string& aiger,
                                 const std::map<std::size_t, bool>& constants);

/// One clock of the same circuit: registers are inputs, behind the others, and their next values
/// outputs, before the others. Throws RtlError if it is no such circuit.
std::string without_registers(const std::string& aiger);

}  // namespace racebeam
