// The digest of a row: what tells that a stored result is as it was measured, and that a frame that
// is measured again repeats.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

struct sqlite3;

namespace racebeam {

/// The column that stands for the picture, if a sweep has it: XXH3 of the colours of its pixels. So
/// the digest of a row is over the picture, too, and can be told from the row alone.
constexpr const char* PictureColumn = "picture";

/// XXH3 of a frame's number and its values, 64 bits each, the lowest byte first.
std::uint64_t frame_digest(int frame, const std::vector<std::int64_t>& values);
/// For PictureColumn: of the colours of a frame.
std::int64_t picture_digest(std::string_view colours);

/// What tells a text from all others: XXH3 of 128 bits, as 32 digits.
std::string text_hash(std::string_view text);

/// From now on SQL of this connection may ask for digest(value, ...): the same of integers; real
/// numbers count as their bits, text and blobs with their length before them.
void add_digest_function(sqlite3* database);

}  // namespace racebeam
