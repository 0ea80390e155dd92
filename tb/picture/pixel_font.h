// Letters of 6 x 13 pixels for pictures: the X Window System's font misc-fixed, which is in the
// public domain ("Public domain font. Share and enjoy.").
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace racebeam {

constexpr int GlyphWidth = 6, GlyphHeight = 13;  // pixels, gaps included

/// Rows of a printable ASCII character, top first, the leftmost pixel in bit 5; of '?' for others.
const std::uint8_t* glyph(char c);

}  // namespace racebeam
