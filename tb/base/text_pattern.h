// TextPattern: a regular expression, of ECMAScript. std::regex behind one source, as each that
// includes it takes five seconds more to compile.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace racebeam {

class TextPattern {
 public:
  /// What matched, and its groups from 1 on; those that took no part are empty.
  using Groups = std::vector<std::string>;

  /// Throws std::runtime_error if it is no regular expression.
  explicit TextPattern(const std::string& expression);

  /// The whole text.
  bool matches(const std::string& text) const { return !match(text).empty(); }
  /// The whole text; empty if it does not match.
  Groups match(const std::string& text) const;
  /// The first place; empty if there is none.
  Groups search(const std::string& text) const;
  /// All places, one behind the other.
  std::vector<Groups> all(const std::string& text) const;
  /// The text with other words in all places.
  std::string replaced(const std::string& text,
                       const std::function<std::string(const Groups&)>& words) const;

 private:
  struct Regex;
  std::shared_ptr<const Regex> regex_;
};

}  // namespace racebeam
