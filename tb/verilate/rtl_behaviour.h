// What RTL does beside logic: loops, and calls that reach beyond the simulation.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/verilate/syntax_tree.h"

namespace racebeam {

/// Sets the loops, calls and reads of `syntax`: of modules, packages, interfaces and classes alike.
void read_behaviour(const SyntaxTree& tree, RtlSyntax& syntax);

}  // namespace racebeam
