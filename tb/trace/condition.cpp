// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/trace/condition.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <list>
#include <utility>
#include <vector>

#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/base/expression.h"
#include "tb/base/nearest.h"
#include "tb/trace/trace_window.h"
#include "tb/wave/signal_look.h"

namespace racebeam {

struct Condition::Parser {
  struct Variable {
    std::function<double(const TracePoint&)> read;
    double value = 0;
  };

  const std::string text;
  const TraceAxis& raster;
  const std::vector<ChipSignal> signals;
  std::list<Variable> variables;  // their places are known to the expression
  Expression expression;

  Parser(const std::string& t, std::vector<ChipSignal> all, const TraceAxis& r)
      : text(t), raster(r), signals(std::move(all)), expression("--when", text, names()) {}

  ExpressionNames names() {
    return {"signal", "state", example(),
            [this](const std::string& name) {
              variables.push_back({reader(name)});
              return &variables.back().value;
            },
            [this](const std::string& name) {
              const ChipSignal* signal = find(name);
              return signal ? state_words(*signal) : nullptr;
            }};
  }

  std::string example() const {
    const ChipSignal& one = example_of(signals);
    const std::vector<std::string>* words = state_words(one);
    return one.path().substr(one.path().find('.') + 1) + " == " + (words ? words->at(1) : "1");
  }

  std::function<double(const TracePoint&)> reader(const std::string& name) const {
    const std::string in_beam = name.rfind("beam.", 0) == 0 ? name.substr(5) : name;
    if (in_beam == (raster.of_pictures ? "picture" : "frame"))
      return [](const TracePoint& at) { return at.frame; };
    if (in_beam == "line")
      return [this](const TracePoint& at) { return raster.line_of_beam(at.line); };
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

  // The same name elsewhere, or the one that needs the fewest edits.
  std::string hint(const std::string& name) const {
    std::vector<std::string> known = {raster.of_pictures ? "picture" : "frame", "line", "pixel",
                                      "clock"};
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

Condition::Condition(const std::string& text, std::vector<ChipSignal> signals,
                     const TraceAxis& raster)
    : parser_(new Parser(text, std::move(signals), raster)) {}
Condition::~Condition() = default;

bool Condition::holds(std::int64_t clock) {
  const TracePoint at = point_at(clock, parser_->raster);
  for (auto& variable : parser_->variables) variable.value = variable.read(at);
  return parser_->expression.holds();
}

}  // namespace racebeam
