// What a true-colour terminal shows after some text: a small interpreter of what TermPicture sends.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>
#include <string>
#include <vector>

#include "tb/picture/rgb_image.h"

namespace racebeam {

class AnsiTerminal {
 public:
  struct Cell {
    std::string letter = " ";
    Rgb ink{}, paper{};
    bool operator==(const Cell& o) const {
      return letter == o.letter && ink == o.ink && paper == o.paper;
    }
  };

  AnsiTerminal(int columns, int rows)
      : columns_(columns), cells_(static_cast<std::size_t>(columns) * rows) {}

  void take(const std::string& text) {
    for (std::size_t i = 0; i < text.size();) {
      if (text[i] == '\x1b') {
        const std::size_t end = text.find_first_of("mHJhl", i);
        if (end == std::string::npos) return;
        sequence(text.substr(i + 2, end - i - 2), text[end]);
        i = end + 1;
      } else if (text[i] == '\n') {
        at_ = (at_ + columns_ - 1) / columns_ * columns_;
        ++i;
      } else {
        const std::size_t bytes = (text[i] & 0xf0) == 0xe0 ? 3 : 1;
        if (at_ < cells_.size()) cells_[at_] = {text.substr(i, bytes), ink_, paper_};
        ++at_;
        i += bytes;
      }
    }
  }
  const Cell& at(int column, int row) const { return cells_[row * columns_ + column]; }
  const std::vector<Cell>& cells() const { return cells_; }
  std::string row(int number) const {
    std::string text;
    for (std::size_t x = 0; x < columns_; ++x) text += cells_[number * columns_ + x].letter;
    return text;
  }

 private:
  void sequence(const std::string& numbers, char end) {
    std::vector<int> n;
    for (const char* at = numbers.c_str(); at != nullptr && *at != '\0';) {
      char* rest = nullptr;
      n.push_back(static_cast<int>(std::strtol(at, &rest, 10)));
      at = *rest == ';' ? rest + 1 : nullptr;
    }
    const auto colour = [&] {
      return Rgb{static_cast<std::uint8_t>(n[2]), static_cast<std::uint8_t>(n[3]),
                 static_cast<std::uint8_t>(n[4])};
    };
    if (end == 'H') at_ = (n.at(0) - 1) * columns_ + n.at(1) - 1;
    if (end == 'J') cells_.assign(cells_.size(), {});
    if (end == 'm' && n.size() == 5) (n[0] == 38 ? ink_ : paper_) = colour();
    if (end == 'm' && n.size() == 1) ink_ = paper_ = {};
  }

  const std::size_t columns_;
  std::vector<Cell> cells_;
  std::size_t at_ = 0;
  Rgb ink_{}, paper_{};
};

}  // namespace racebeam
