// Pictures in fewer bytes: what crosses pipes and lies in stores.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tb/base/packed_picture.h"

namespace racebeam {

/// Any bytes, by zlib.
std::string packed(std::string_view bytes);
/// The `size` bytes again. Throws std::runtime_error if they are others.
std::string unpacked(std::string_view bytes, std::size_t size);

/// A picture's colours, of six bits each, as runs of one colour. zlib would halve them again, and
/// take longer to unpack than a picture takes to compare.
std::string packed_colours(const std::vector<std::uint8_t>& colours);
/// As many colours as there are places for. Throws std::runtime_error if they are not so many.
void unpack_colours(std::string_view bytes, std::vector<std::uint8_t>& colours);

/// A picture with its size and depth, by zlib.
std::string packed_picture(const PackedPicture& picture);
/// The same again. Throws std::runtime_error if it is none.
PackedPicture unpacked_picture(std::string_view bytes);

/// Whole numbers as decimals, a space between them.
std::string text_of_numbers(const std::vector<std::int64_t>& numbers);
/// The same again. Throws std::runtime_error of anything else.
std::vector<std::int64_t> numbers_of_text(std::string_view text);

/// As digits, for text.
std::string hex_of(std::string_view bytes);
/// Throws std::runtime_error of other characters.
std::string of_hex(std::string_view digits);

}  // namespace racebeam
