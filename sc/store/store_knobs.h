// What an architect may change of the frame store, and what an engine makes of it. An engine's
// knobs contain one.
//
// The units that draw into a frame store share it: write_buffer, store_arbiter, frame_memory and
// frame_scanout.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace racebeam {

/// In which clocks a word may go from the write buffer to the memory.
enum write_policy_rule {
  WritePolicySync = 0,      ///< hsync or vsync is low
  WritePolicyBlanking = 1,  ///< no visible pixel
  WritePolicyFree = 2,      ///< the beam does not read
};
/// What happens to a word that finds the write buffer full.
enum when_full_rule {
  WhenFullStall = 0,  ///< it waits
  WhenFullDrop = 1,   ///< nobody looks: all that the buffer holds is lost, the word stays alone
};
/// How pixels stand in words of the memory. The row is y_i + 240, the column 0 at the left.
enum store_format_rule {
  /// A pixel a word: bit 3 * colour_bits tells that it is the light; below it red, green, blue of
  /// colour_bits each, blue lowest. Address {row[8:0], column[8:0]}; pictures wider than 512:
  /// {row[8:0], column[9:0]}.
  StoreRgbLight = 0,
  /// A pixel a word: red, green, blue of 8 bits each, blue lowest. Address {row[8:0], column[9:0]}.
  StoreRgb888 = 1,
  /// Eight pixels in three words, one a plane: red, green, blue; a byte a pixel, the left one
  /// lowest. Address (plane * picture_height + row[8:0]) * (picture_width / 8) + column / 8.
  StorePlanar = 2,
};

constexpr int StoreAddressBits = 20;  // of ports
constexpr int StoreDataBits = 64;     // of ports
constexpr int DacBits = 10;           // of a colour at the pins
constexpr int MaxWriteBuffer = 128;   // entries

struct store_knobs {
  int write_buffer_depth = 64;         ///< entries, 1..128
  int write_policy = WritePolicySync;  ///< write_policy_rule
  int when_full = WhenFullStall;       ///< when_full_rule
  int wrap_right = 0;                  ///< 1: columns right of the picture are not made black

  // An engine sets these.
  int store_format = StoreRgbLight;  ///< store_format_rule
  int colour_bits = 5;               ///< a channel, 4..8; StoreRgbLight only
  int picture_width = 512;           ///< columns, whole groups of 8; the beam shows 640
  int picture_height = 480;          ///< rows; StorePlanar only: the size of a plane

  /// Bits of an address and of a word that are kept: the low ones of the ports.
  int address_bits() const {
    return store_format == StorePlanar ? StoreAddressBits : 9 + column_bits();
  }
  int data_bits() const {
    return store_format == StoreRgbLight ? 3 * colour_bits + 1
           : store_format == StoreRgb888 ? 24
                                         : StoreDataBits;
  }
  /// Bits of an address that are the column, where a word is a pixel.
  int column_bits() const { return store_format == StoreRgb888 || picture_width > 512 ? 10 : 9; }
  /// Words that the beam reads for a group of pixels, and how many pixels that are.
  int group_words() const { return store_format == StorePlanar ? 3 : 1; }
  int group_pixels() const { return store_format == StorePlanar ? 8 : 1; }
};

}  // namespace racebeam
