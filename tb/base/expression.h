// Expression: a condition over named numbers, such as `line == 240 && state_q == bisect`.
//
// Operators, as in C: ( ) ! - * / + < <= > >= == != && || ?: and bit(x, n), ceil(x), log10(x).
// Behind `==` or `!=` a name whose values are words is compared with one of them. The parser is
// muParser: numbers are doubles, exact up to 53 bits; what is divided by 0 is infinite, and does
// not hold.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace racebeam {

/// What an expression may name. The functions are called while it is made, and not after.
struct ExpressionNames {
  std::string kind;     ///< "signal": what a name is
  std::string word;     ///< "state": what a word is
  std::string example;  ///< of an expression
  /// Where the value of a name stands, for as long as the expression lives. Throws UsageError if
  /// there is none of that name.
  std::function<double*(const std::string& name)> value;
  /// The words for the values 0.. of a name; null: its values are numbers, or it is unknown.
  std::function<const std::vector<std::string>*(const std::string& name)> words;
};

class Expression {
 public:
  static constexpr std::size_t Longest = 1000;  ///< characters

  /// Throws UsageError, which begins with `asker`, such as --when, and the text: no such name or
  /// word, not an expression, several of them, no name at all.
  Expression(const std::string& asker, const std::string& text, const ExpressionNames& names);
  ~Expression();

  /// Whether it is not 0, with the values as they are now.
  bool holds();
  /// What it is.
  double value();

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

}  // namespace racebeam
