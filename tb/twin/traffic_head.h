// The text in front of a file of port traffic.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/twin/traffic_file.h"

namespace racebeam {

/// Of the file's format, not of the program.
constexpr int TrafficVersion = 1;
/// The first word, and the last line.
constexpr const char* TrafficMagic = "racebeam-traffic";
constexpr const char* TrafficHeadEnd = "end\n";

std::string head_text(const TrafficHead& head);

/// What head_text() wrote. Throws std::runtime_error, which says what is wrong with it.
TrafficHead head_of(const std::string& text);

}  // namespace racebeam
