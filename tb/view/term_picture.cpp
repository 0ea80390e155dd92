// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/term_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "sc/base/constants.h"

namespace racebeam {

namespace {

constexpr const char* HalfBlock = "\xe2\x96\x80";
constexpr const char* Plain = "\x1b[0m";
constexpr Rgb White{235, 235, 235}, Shade{16, 16, 22};

/// Mean of the box of the picture that pixel (x, y) of width x height stands for.
Rgb mean(const RgbImage& picture, int x, int y, int width, int height) {
  const auto begin = [](int i, int count, int pixels) { return i * pixels / count; };
  const int left = begin(x, width, picture.width()), top = begin(y, height, picture.height());
  const int right = std::max(begin(x + 1, width, picture.width()), left + 1);
  const int bottom = std::max(begin(y + 1, height, picture.height()), top + 1);
  int r = 0, g = 0, b = 0;
  for (int row = top; row < bottom; ++row)
    for (int column = left; column < right; ++column) {
      const Rgb pixel = picture.at(column, row);
      r += pixel.r, g += pixel.g, b += pixel.b;
    }
  const int area = (right - left) * (bottom - top);
  const auto part = [area](int sum) { return static_cast<std::uint8_t>((sum + area / 2) / area); };
  return {part(r), part(g), part(b)};
}

}  // namespace

TermPicture::Cells TermPicture::cells_of(const RgbImage& picture,
                                         const std::vector<std::string>& words,
                                         const std::string& status, TermSize size) {
  Cells cells(static_cast<std::size_t>(size.columns) * size.rows);
  const int most = std::max(size.rows - 1, 1);  // rows for the picture
  const int width = std::clamp(most * 2 * VisibleColumns / VisibleRows, 1,
                               std::min(size.columns, picture.width()));
  const int height = std::max(width * VisibleRows / VisibleColumns / 2, 1) * 2;
  const int left = (size.columns - width) / 2;
  for (int row = 0; row < height / 2 && row < size.rows; ++row)
    for (int x = 0; x < width; ++x)
      cells[row * size.columns + left + x] = {mean(picture, x, 2 * row, width, height),
                                              mean(picture, x, 2 * row + 1, width, height)};
  const auto write = [&](int row, int column, const std::string& line) {
    for (std::size_t i = 0; i < line.size() && column < size.columns; ++i, ++column)
      cells[row * size.columns + column] = {White, Shade, line[i]};
  };
  for (int i = 0; i < static_cast<int>(words.size()) && i + 1 < size.rows; ++i)
    write(i, 1, fmt::format(" {:<48} ", words[i]));
  if (size.rows > 1) write(size.rows - 1, 0, fmt::format("{:<{}}", status, size.columns));
  return cells;
}

// `ink` has the colours that are set; `first`: none are.
void TermPicture::append(std::string& text, const Cell& cell, Cell& ink, bool first) {
  if (first || cell.upper != ink.upper)
    text += fmt::format("\x1b[38;2;{};{};{}m", cell.upper.r, cell.upper.g, cell.upper.b);
  if (first || cell.lower != ink.lower)
    text += fmt::format("\x1b[48;2;{};{};{}m", cell.lower.r, cell.lower.g, cell.lower.b);
  ink = cell;
  if (cell.letter) text += cell.letter < ' ' || cell.letter > '~' ? '?' : cell.letter;
  else text += HalfBlock;
}

std::string TermPicture::draw(const RgbImage& picture, const std::vector<std::string>& words,
                              const std::string& status, TermSize size) {
  Cells cells = cells_of(picture, words, status, size);
  const bool all = size.columns != size_.columns || size.rows != size_.rows;
  std::string text = all ? "\x1b[0m\x1b[2J" : "";
  Cell ink;
  bool first = true;
  int after = -1;  // the cell behind the cursor
  for (int i = 0; i < static_cast<int>(cells.size()); ++i) {
    if (!all && cells[i] == shown_[i]) continue;
    if (i != after || i % size.columns == 0)
      text += fmt::format("\x1b[{};{}H", i / size.columns + 1, i % size.columns + 1);
    append(text, cells[i], ink, first);
    first = false;
    after = i + 1;
  }
  if (!first) text += Plain;
  shown_ = std::move(cells);
  size_ = size;
  return text;
}

std::string TermPicture::page(const RgbImage& picture, const std::vector<std::string>& words,
                              const std::string& status, TermSize size) {
  const Cells cells = cells_of(picture, words, status, size);
  std::string text;
  Cell ink;
  for (int i = 0; i < static_cast<int>(cells.size()); ++i) {
    append(text, cells[i], ink, i % size.columns == 0);
    if ((i + 1) % size.columns == 0) text += std::string(Plain) + "\n";
  }
  return text;
}

}  // namespace racebeam
