// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/document.h"

#include <cctype>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace racebeam {

std::string page(const std::string& path) {
  std::ifstream file(RACEBEAM_SOURCE_DIR "/" + path);
  if (!file) throw std::runtime_error("no page " + path);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::vector<std::string>> table_rows(const std::string& text,
                                                 const std::string& heading, int n) {
  const auto begin = text.find("\n" + heading);
  if (begin == std::string::npos) throw std::runtime_error("no heading " + heading);
  std::istringstream section(text.substr(begin + 1, text.find("\n#", begin + 1) - begin - 1));
  std::vector<std::vector<std::string>> rows;
  int table = -1;
  bool inside = false, head = false;
  for (std::string line; std::getline(section, line);) {
    const bool row = !line.empty() && line[0] == '|';
    if (row && !inside) ++table;
    if (row && !inside) head = true;
    inside = row;
    if (!row) continue;
    if (line.compare(0, 4, "|---") == 0) head = false;
    else if (!head && (n == -1 || n == table)) {
      std::istringstream cells(line.substr(1, line.rfind('|') - 1));
      rows.emplace_back();
      for (std::string cell; std::getline(cells, cell, '|');) {
        const auto from = cell.find_first_not_of(' ');
        rows.back().push_back(from == std::string::npos
                                  ? ""
                                  : cell.substr(from, cell.find_last_not_of(' ') + 1 - from));
      }
    }
  }
  if (rows.empty()) throw std::runtime_error("no table under " + heading);
  return rows;
}

std::vector<int> numbers(const std::string& text) {
  std::vector<int> all;
  for (std::size_t at = 0; at < text.size();) {
    const bool sign = text[at] == '-' && at + 1 < text.size() && isdigit(text[at + 1]);
    if (!isdigit(text[at]) && !sign) {
      ++at;
      continue;
    }
    std::size_t used = 0;
    all.push_back(std::stoi(text.substr(at), &used));
    at += used;
  }
  return all;
}

}  // namespace racebeam
