// How large the memories of a netlist are.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

namespace racebeam {

/// The bits of all memories in RTLIL that something is written to.
std::size_t written_bits(const std::string& rtlil);

}  // namespace racebeam
