// TermPicture: pictures as text for a true-colour terminal; only what has changed is written.
//
// A character is two pixels, one above the other: a half block in the colour of the upper one on
// the colour of the lower one.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/picture/rgb_image.h"

namespace racebeam {

/// Characters of a terminal.
struct TermSize {
  int columns = 80, rows = 24;
};

class TermPicture {
 public:
  /// The text that makes a terminal show `picture`, which a screen makes 4:3, as large as fits
  /// above one line for `status`, with `words` over its top left; means of pixels, as a smaller
  /// screen would. It starts from what the call before has left, or from anything after another
  /// size.
  std::string draw(const RgbImage& picture, const std::vector<std::string>& words,
                   const std::string& status, TermSize size);
  /// The same as rows of text from top to bottom that depend on nothing before.
  std::string page(const RgbImage& picture, const std::vector<std::string>& words,
                   const std::string& status, TermSize size);

 private:
  struct Cell {
    Rgb upper{0, 0, 0}, lower{0, 0, 0};
    char letter = 0;  // instead of a half block: white on `lower`
    bool operator==(const Cell& o) const {
      return upper == o.upper && lower == o.lower && letter == o.letter;
    }
  };
  using Cells = std::vector<Cell>;

  static Cells cells_of(const RgbImage& picture, const std::vector<std::string>& words,
                        const std::string& status, TermSize size);
  static void append(std::string& text, const Cell& cell, Cell& ink, bool first);

  TermSize size_{0, 0};
  Cells shown_;
};

}  // namespace racebeam
