// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/base/text_pattern.h"

#include <regex>

namespace racebeam {

struct TextPattern::Regex : std::regex {
  using std::regex::regex;
};

namespace {

TextPattern::Groups groups_of(const std::smatch& match) {
  TextPattern::Groups groups;
  for (const auto& group : match) groups.push_back(group.str());
  return groups;
}

}  // namespace

TextPattern::TextPattern(const std::string& expression)
    : regex_(std::make_shared<const Regex>(expression)) {}

TextPattern::Groups TextPattern::match(const std::string& text) const {
  std::smatch found;
  return std::regex_match(text, found, *regex_) ? groups_of(found) : Groups();
}

TextPattern::Groups TextPattern::search(const std::string& text) const {
  std::smatch found;
  return std::regex_search(text, found, *regex_) ? groups_of(found) : Groups();
}

std::vector<TextPattern::Groups> TextPattern::all(const std::string& text) const {
  std::vector<Groups> places;
  for (std::sregex_iterator at(text.begin(), text.end(), *regex_), end; at != end; ++at)
    places.push_back(groups_of(*at));
  return places;
}

std::string TextPattern::replaced(const std::string& text,
                                  const std::function<std::string(const Groups&)>& words) const {
  std::string result;
  auto rest = text.begin();
  for (std::sregex_iterator at(text.begin(), text.end(), *regex_), end; at != end; ++at) {
    result.append(rest, (*at)[0].first);
    result += words(groups_of(*at));
    rest = (*at)[0].second;
  }
  return result.append(rest, text.end());
}

}  // namespace racebeam
