// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/help_text.h"

#include <sstream>

namespace racebeam {

namespace {

constexpr std::size_t Columns = 100;

}  // namespace

std::string help_entry(const std::string& name, const std::string& text, std::size_t left) {
  std::string all = "  " + name;
  if (text.empty()) return all + "\n";
  if (all.size() >= left) all += "\n" + std::string(left, ' ');
  else all.resize(left, ' ');
  std::size_t column = left;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (column > left && column + 1 + word.size() > Columns) {
      all += "\n" + std::string(left, ' ');
      column = left;
    }
    if (column > left) ++column, all += ' ';
    all += word;
    column += word.size();
  }
  return all + "\n";
}

}  // namespace racebeam
