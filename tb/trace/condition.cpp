// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/trace/condition.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <list>
#include <regex>
#include <utility>
#include <vector>

#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/base/nearest.h"
#include "tb/trace/trace_window.h"
#include "tb/wave/signal_look.h"

namespace racebeam {

namespace {

constexpr const char* NameCharacters =
    "0123456789_.[]abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";

double one_bit(double value, double bit) {
  return static_cast<double>(static_cast<std::uint64_t>(static_cast<std::int64_t>(value)) >>
                                 static_cast<unsigned>(bit) &
                             1);
}

double logical_not(double value) { return value == 0; }

// "0x1f" at the start of `text`.
int hexadecimal(const char* text, int* position, double* value) {
  if (text[0] != '0' || (text[1] != 'x' && text[1] != 'X')) return 0;
  char* end = nullptr;
  *value = static_cast<double>(std::strtoull(text, &end, 16));
  *position += static_cast<int>(end - text);
  return end - text > 2;
}

/// What muParser would take for something else: `=` assigns to it, `^` is a power, `,` separates
/// conditions of which the last one counts.
void refuse_surprises(const std::string& text) {
  const auto refuse = [&](std::size_t at, const std::string& help) {
    throw UsageError(
        fmt::format("--when '{}': '{}' at character {}; {}", text, text[at], at + 1, help));
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

}  // namespace

struct Condition::Parser {
  struct Variable {
    std::function<double(const TracePoint&)> read;
    double value = 0;
  };

  const std::string text;
  const Raster& raster;
  const std::vector<ChipSignal> signals;
  mu::Parser parser;
  std::list<Variable> variables;  // their places are known to the parser

  Parser(const std::string& t, std::vector<ChipSignal> all, const Raster& r)
      : text(t), raster(r), signals(std::move(all)) {
    refuse_surprises(text);
    parser.DefineNameChars(NameCharacters);
    parser.ClearConst();
    parser.ClearFun();
    parser.DefineInfixOprt("!", logical_not);
    parser.DefineFun("bit", one_bit);
    parser.AddValIdent(hexadecimal);
    parser.SetVarFactory(make, this);
    parser.SetExpr(with_numbers(text));
    evaluate();
    if (parser.GetNumResults() != 1)
      throw UsageError("--when '" + text + "' is several conditions; join them with && or ||");
    if (variables.empty())
      throw UsageError("--when '" + text + "' names no signal; try 'u_subdivider.sd_q == 4'");
  }

  double evaluate() {
    try {
      return parser.Eval();
    } catch (const mu::Parser::exception_type& error) {
      throw UsageError(fmt::format("--when '{}': {}", text, error.GetMsg()));
    }
  }

  static double* make(const char* name, void* self) {
    return static_cast<Parser*>(self)->variable(name);
  }

  double* variable(const std::string& name) {
    variables.push_back({reader(name)});
    return &variables.back().value;
  }

  std::function<double(const TracePoint&)> reader(const std::string& name) const {
    const std::string in_beam = name.rfind("beam.", 0) == 0 ? name.substr(5) : name;
    if (in_beam == "frame") return [](const TracePoint& at) { return at.frame; };
    if (in_beam == "line") return [](const TracePoint& at) { return at.line; };
    if (in_beam == "clock") return [](const TracePoint& at) { return at.clock; };
    if (in_beam == "pixel") return [this](const TracePoint& at) { return at.pixel(raster); };
    if (const ChipSignal* signal = find(name)) return reader(*signal);
    throw UsageError(
        fmt::format("--when '{}': there is no signal '{}'; {}", text, name, hint(name)));
  }

  // By its path; or by its last name, if only one signal has it.
  const ChipSignal* find(const std::string& name) const {
    for (const std::string& path : {name, "chip." + name})
      for (const ChipSignal& signal : signals)
        if (signal.path() == path) return &signal;
    const std::string last = name.substr(name.rfind('.') + 1);
    const auto is_it = [&](const ChipSignal& signal) { return signal.name == last; };
    const auto only = std::find_if(signals.begin(), signals.end(), is_it);
    if (only == signals.end() || std::find_if(only + 1, signals.end(), is_it) != signals.end())
      return nullptr;
    if (last != name) tell("--when: " + name + " is " + only->path());
    return &*only;
  }

  // The words behind state registers become their values.
  std::string with_numbers(const std::string& given) const {
    static const std::regex compared(R"(([A-Za-z_][\w.\[\]]*)(\s*[!=]=\s*)([A-Za-z_]\w*))");
    std::string result;
    auto rest = given.cbegin();
    for (std::smatch match; std::regex_search(rest, given.cend(), match, compared);) {
      result.append(rest, match[3].first);
      rest = match[3].second;
      const ChipSignal* signal = find(match[1]);
      const auto* words = signal ? state_words(*signal) : nullptr;
      result += words ? std::to_string(value_of(match[3], match[1], *words)) : match[3].str();
    }
    return result.append(rest, given.cend());
  }

  long value_of(const std::string& word, const std::string& name,
                const std::vector<std::string>& words) const {
    const auto at = std::find(words.begin(), words.end(), word);
    if (at == words.end())
      throw UsageError(fmt::format("--when '{}': {} has no state '{}' (there is: {})", text, name,
                                   word, fmt::join(words, ", ")));
    return at - words.begin();
  }

  // The same name elsewhere, or the one that needs the fewest edits.
  std::string hint(const std::string& name) const {
    std::vector<std::string> known = {"frame", "line", "pixel", "clock"};
    const std::string last = name.substr(name.rfind('.') + 1);
    for (const ChipSignal& signal : signals) {
      const std::string path = signal.path();
      if (signal.name == last) return "did you mean '" + path + "'?";
      known.insert(known.end(), {path, path.substr(path.find('.') + 1)});
    }
    const std::string close = nearest(name, known);
    return close.empty() ? "a waveform of one clock shows all names"
                         : "did you mean '" + close + "'?";
  }

  static std::function<double(const TracePoint&)> reader(const ChipSignal& signal) {
    const bool is_signed = format_of(signal.name, signal.bits) == NumberFormat::Signed;
    const double wrap = std::ldexp(1.0, signal.bits), half = wrap / 2;
    return [signal, is_signed, wrap, half](const TracePoint&) {
      const auto value = static_cast<double>(signal.read());
      return is_signed && value >= half ? value - wrap : value;
    };
  }
};

Condition::Condition(const std::string& text, std::vector<ChipSignal> signals, const Raster& raster)
    : parser_(new Parser(text, std::move(signals), raster)) {}
Condition::~Condition() = default;

bool Condition::holds(std::int64_t clock) {
  const TracePoint at = point_at(clock, parser_->raster);
  for (auto& variable : parser_->variables) variable.value = variable.read(at);
  return std::isnormal(parser_->evaluate());
}

}  // namespace racebeam
