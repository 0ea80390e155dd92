// Which mutants of a unit's RTL were proved equal before, in a file that can be kept in the tree.
//
// Its first line that is no comment is "circuit KEY", the key of what the proofs were asked of;
// then a line for each mutant, its name as the page of the sign-off has it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>

#include "tb/twin/unit_under_test.h"

namespace racebeam {

using MutantNames = std::set<std::string>;

/// Where those of the project's own RTL are kept.
std::string known_proofs(const UnitUnderTest& dut);

/// The names in such a file; none if it is of another circuit, or not there.
MutantNames read_proved(const std::string& path, const std::string& circuit);
std::string proved_text(const std::string& unit, const std::string& circuit,
                        const MutantNames& names);

}  // namespace racebeam
