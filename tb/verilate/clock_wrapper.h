// A module around RTL that is to be verilated, so that a clock costs one evaluation.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/verilate/comb_paths.h"
#include "tb/verilate/rtl_sources.h"
#include "tb/verilate/rtl_syntax.h"

namespace racebeam {

constexpr const char* Wrapper = "racebeam_wrapper";     ///< the module
constexpr const char* Wrapped = "racebeam_wrapped";     ///< the instance in it
constexpr const char* Tick = "racebeam_tick";           ///< its input in the place of the clock
constexpr const char* TickSeen = "racebeam_tick_seen";  ///< its register that follows it
/// Before a number: its input that changes with others, those of one group, which it takes then:
/// Verilator evaluates what hangs on an input each time, and what hangs on a register when that
/// changes, so that a clock does not pay for inputs that have not moved, nor one for another group.
constexpr const char* Take = "racebeam_take_";

constexpr int MostGroups = 30;  ///< those beyond are one with the last

/// Whether `sources` want one: a whole chip, for the registers before its inputs, and what uses
/// nothing but the rising edge of its clock.
bool is_wrapped(const RtlSources& sources, const RtlSyntax& syntax);

/// Before a number: its input with what a register gets that can be written to; and the input whose
/// bit of that number says that it gets it.
constexpr const char* Door = "racebeam_door_";
constexpr const char* Knock = "racebeam_knock";

/// The inputs that it takes, of what it has in `groups`, with numbers from 0 on. None of RTL that
/// says something when an input moves, or of which something is counted.
CombGroups taken_inputs(const RtlSources& sources, const RtlSyntax& syntax,
                        const CombGroups& groups);

/// Its text: the ports of the RTL, which gets its parameters here. If only rising edges matter,
/// each change of Tick is a whole clock, in one evaluation; otherwise the clock is a port as it
/// was.
std::string clock_wrapper(const RtlSources& sources, const RtlSyntax& syntax,
                          const CombGroups& taken);

}  // namespace racebeam
