// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/csv_rows.h"

namespace racebeam {

std::vector<std::map<std::string, std::string>> csv_rows(const std::string& text) {
  std::vector<std::vector<std::string>> lines = {{""}};
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string& cell = lines.back().back();
    const char c = text[i];
    if (c == '"' && quoted && i + 1 < text.size() && text[i + 1] == '"') cell += text[i++];
    else if (c == '"') quoted = !quoted;
    else if (quoted || (c != ',' && c != '\n' && c != '\r')) cell += c;
    else if (c == ',') lines.back().emplace_back();
    else if (c == '\n' && i + 1 < text.size()) lines.push_back({""});
  }
  std::vector<std::map<std::string, std::string>> rows;
  for (std::size_t line = 1; line < lines.size(); ++line) {
    rows.emplace_back();
    lines[line].resize(lines[0].size());
    for (std::size_t i = 0; i < lines[0].size(); ++i) rows.back()[lines[0][i]] = lines[line][i];
  }
  return rows;
}

}  // namespace racebeam
