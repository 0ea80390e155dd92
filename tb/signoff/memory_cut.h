// Memories left out of a circuit: what is written to them are outputs, and what is read, inputs.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace racebeam {

/// The file of modules that MemoryCut needs in the folder of yosys.
constexpr const char* WrittenFile = "written.v";
/// In it: a memory whose addresses and words are 0 where nothing is written.
extern const char* const WrittenMemory;
/// Commands of yosys in place of `memory`. Memories that nothing writes stay.
constexpr const char* MemoryCut =
    "memory -nordff -nomap\n"
    "techmap -max_iter 1 -map written.v t:$mem_v2 r:WR_PORTS>0 %i\n"
    "expose -evert t:$mem_v2 r:WR_PORTS>0 %i\nmemory_map\n";

}  // namespace racebeam
