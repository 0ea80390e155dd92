// How a signal is shown, wherever it is shown: the format of its numbers, and its role as a colour.
//
// Both follow from the name and the width; the names are those of the units' ports and registers.
// The save file for GTKWave and the picture of a waveform look alike through it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace racebeam {

enum class NumberFormat { Words, Bit, Signed, Decimal, Hex };
enum class SignalRole { Wire, Input, Output, Register, Words };

/// Of a signal with this name, without its scope; `bits` 0: words.
NumberFormat format_of(const std::string& name, int bits);
SignalRole role_of(const std::string& name, int bits);

/// The value as it is shown: "-3", "306", "0x0a" ("5" if it has 3 bits), or the word itself.
/// `digits` are binary, leading zeros left out or not; digits that are not 0 or 1 make it "x".
std::string formatted(const std::string& digits, NumberFormat format, int bits);

}  // namespace racebeam
