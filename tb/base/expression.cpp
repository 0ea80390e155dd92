// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/base/expression.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "tb/base/errors.h"
#include "tb/base/text_pattern.h"

namespace racebeam {

namespace {

constexpr const char* NameCharacters =
    "0123456789_.[]abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";

double one_bit(double value, double bit) {
  return std::fabs(std::fmod(std::floor(value * std::exp2(-std::trunc(bit))), 2));
}

double rounded_up(double value) { return std::ceil(value); }

double logarithm(double value) { return std::log10(value); }

double logical_not(double value) { return value == 0; }

// "0x1f" at the start of `text`.
int hexadecimal(const char* text, int* position, double* value) {
  if (text[0] != '0' || (text[1] != 'x' && text[1] != 'X')) return 0;
  char* end = nullptr;
  *value = static_cast<double>(std::strtoull(text, &end, 16));
  if (end - text <= 2) return 0;
  *position += static_cast<int>(end - text);
  return 1;
}

}  // namespace

struct Expression::Parser {
  const std::string head;  // of a message
  const ExpressionNames names;
  mu::Parser parser;
  bool named = false;

  Parser(const std::string& asker, const std::string& text, const ExpressionNames& known)
      : head(asker + " '" + text + "'"), names(known) {
    if (text.size() > Longest)
      throw UsageError(fmt::format("{} has {} characters; it may have {}", asker, text.size(),
                                   std::size_t{Longest}));
    refuse_surprises(text);
    parser.DefineNameChars(NameCharacters);
    parser.ClearConst();
    parser.ClearFun();
    parser.DefineInfixOprt("!", logical_not);
    parser.DefineFun("bit", one_bit);
    parser.DefineFun("ceil", rounded_up);
    parser.DefineFun("log10", logarithm);
    parser.AddValIdent(hexadecimal);
    parser.SetVarFactory(make, this);
    parser.SetExpr(with_numbers(text));
    evaluate();
    if (parser.GetNumResults() != 1)
      throw UsageError(head + " is several conditions; join them with && or ||");
    if (!named)
      throw UsageError(head + " names no " + names.kind + "; try '" + names.example + "'");
  }

  double evaluate() {
    try {
      return parser.Eval();
    } catch (const mu::Parser::exception_type& error) {
      throw UsageError(head + ": " + error.GetMsg());
    }
  }

 private:
  static double* make(const char* name, void* self) {
    Parser& parser = *static_cast<Parser*>(self);
    parser.named = true;
    return parser.names.value(name);
  }

  /// What muParser would take for something else: `=` assigns to it, `^` is a power, `,` separates
  /// conditions of which the last one counts.
  void refuse_surprises(const std::string& text) const {
    const auto refuse = [&](std::size_t at, const std::string& help) {
      throw UsageError(fmt::format("{}: '{}' at character {}; {}", head, text[at], at + 1, help));
    };
    for (auto at = text.find('='); at != std::string::npos; at = text.find('=', at + 1)) {
      if (at + 1 < text.size() && text[at + 1] == '=') ++at;
      else if (at == 0 || std::string("=!<>").find(text[at - 1]) == std::string::npos)
        refuse(at, "to compare write '=='");
    }
    for (std::size_t at = 0; at < text.size(); ++at) {
      const bool twice = at + 1 < text.size() && text[at + 1] == text[at];
      if (std::string("&|").find(text[at]) != std::string::npos && twice) ++at;
      else if (std::string("&|^").find(text[at]) != std::string::npos)
        refuse(at, "bits are read by bit(x, n); to join conditions write '&&' or '||'");
    }
    if (const auto at = text.find_first_of("'\""); at != std::string::npos)
      refuse(at, "leave out the inner quotes");
  }

  // The words become their values.
  std::string with_numbers(const std::string& given) const {
    static const TextPattern compared(R"(([A-Za-z_][\w.\[\]]*)(\s*[!=]=\s*)([A-Za-z_]\w*))");
    return compared.replaced(given, [this](const TextPattern::Groups& match) {
      const auto* words = names.words(match[1]);
      return words ? match[1] + match[2] + std::to_string(value_of(match[3], match[1], *words))
                   : match[0];
    });
  }

  long value_of(const std::string& word, const std::string& name,
                const std::vector<std::string>& words) const {
    const auto at = std::find(words.begin(), words.end(), word);
    if (at == words.end())
      throw UsageError(fmt::format("{}: {} has no {} '{}' (there is: {})", head, name, names.word,
                                   word, fmt::join(words, ", ")));
    return at - words.begin();
  }
};

Expression::Expression(const std::string& asker, const std::string& text,
                       const ExpressionNames& names)
    : parser_(new Parser(asker, text, names)) {}
Expression::~Expression() = default;

double Expression::value() { return parser_->evaluate(); }

bool Expression::holds() { return std::isnormal(parser_->evaluate()); }

}  // namespace racebeam
