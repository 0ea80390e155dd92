// What `racebeam bench` counts of the frame store: not seconds of this machine, but clocks that a
// tracer waits for its write buffer, and words that it loses, by depth.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace racebeam {

/// A row for each rule of the write buffer, depth, and clocks of a pixel: "write_policy",
/// "when_full", "write_buffer_depth", "pixel_clocks"; "words", "lost", "clocks", "waited"; and
/// "lost_percent", "waited_percent".
nlohmann::json store_rows();

/// Those as tables, a line for each depth.
std::string store_tables(const nlohmann::json& rows);

}  // namespace racebeam
