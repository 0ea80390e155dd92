// What "contract 9.5" in a file means: the sections that it cites, and those that a page has.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>
#include <vector>

#include "tb/base/text_pattern.h"

namespace racebeam {

/// What of a page can be cited: the numbers of its headings, "9", "9.5", and the items of its
/// tables, letters in the first column.
inline std::set<std::string> citable(const std::string& page) {
  std::set<std::string> all;
  static const TextPattern place("(?:^|\n)(?:#+ (\\d+(?:\\.\\d+)?)\\.? |\\| ([A-Z]) \\|)");
  for (const TextPattern::Groups& found : place.all(page))
    all.insert(found[found[1].empty() ? 2 : 1]);
  return all;
}

/// A file in one line: the marks of comments go with the breaks.
inline std::string without_line_breaks(const std::string& file) {
  std::string text;
  for (std::size_t at = 0; at < file.size(); ++at) {
    if (file[at] != '\n') {
      text += file[at];
      continue;
    }
    at = file.find_first_not_of(" \t\n/#*!<", at);
    if (at == std::string::npos) break;
    text += ' ';
    --at;
  }
  return text;
}

/// What a file cites: "contract 9.5", "Contract sections 5.1, 5.2 and 6", "contract 9.4 to 9.7",
/// "contract 18, item S" (which cites "18" and "S"); also where a comment breaks the line.
inline std::vector<std::string> citations(const std::string& file) {
  static const TextPattern cited(
      "^ontract(?: sections?)? (\\d+(?:\\.\\d+)?(?:(?:, and|,| and| to) \\d+(?:\\.\\d+)?)*)"
      "(?:,? and item ([A-Z])|,? item ([A-Z]))?");
  static const TextPattern number("\\d+(?:\\.\\d+)?");
  constexpr std::size_t LongestCitation = 200;
  const std::string text = without_line_breaks(file);
  std::vector<std::string> all;
  for (auto at = text.find("ontract"); at != std::string::npos; at = text.find("ontract", at + 1)) {
    const TextPattern::Groups found = cited.search(text.substr(at, LongestCitation));
    if (found.empty()) continue;
    for (const TextPattern::Groups& one : number.all(found[1])) all.push_back(one[0]);
    for (const int group : {2, 3})
      if (!found[group].empty()) all.push_back(found[group]);
  }
  return all;
}

/// The citations of a file that lead nowhere.
inline std::vector<std::string> unresolved(const std::string& file,
                                           const std::set<std::string>& citable) {
  std::vector<std::string> lost;
  for (const std::string& one : citations(file))
    if (!citable.count(one)) lost.push_back(one);
  return lost;
}

}  // namespace racebeam
