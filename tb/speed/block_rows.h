// What `racebeam bench cores` and `bench pictures` count: clocks that the block renderer takes, by
// the number of its cores, and picture by picture while the spheres move.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace racebeam {

/// A row for each number of cores that draw the scene block/forty: "cores", "clocks" of the
/// picture, "busy", the share of their clocks in which they draw, "bus_stalls",
/// "pictures_per_second" at 50.4 MHz. Throws UsageError if the scene is not there.
nlohmann::json core_rows();
/// Those as a table, as docs/block.md has it.
std::string core_text(const nlohmann::json& rows);

/// 900 pictures of the scene block/bounce by the standard cores, as the source lists them: a row
/// for the first and every 30th: "picture", "milliseconds" at 50.4 MHz, and at the end one with the
/// "pictures" and "milliseconds" of all. Throws UsageError if the scene is not there.
nlohmann::json picture_rows();
std::string picture_text(const nlohmann::json& rows);

}  // namespace racebeam
