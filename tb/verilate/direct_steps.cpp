// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/direct_steps.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>

#include "tb/base/text_pattern.h"
#include "tb/base/whole_file.h"
#include "tb/verilate/class_body.h"
#include "tb/verilate/clock_wrapper.h"
#include "tb/verilate/needless_steps.h"

namespace racebeam {

namespace {

/// Whether eval() does nothing but look for triggers: no values are sampled for properties, say.
bool only_looks(const std::string& body) {
  static const TextPattern Signal(R"(vlSelf->(\w+))"),
      Own("__V(ico|act|nba)(Triggered|IterCount|Continue)|vlSymsp");
  const auto signals = Signal.all(body);
  return !body.empty() && std::all_of(signals.begin(), signals.end(),
                                      [](const auto& signal) { return Own.matches(signal[1]); });
}

/// What a body does: calls, each upon one of some triggers.
struct Call {
  std::set<int> triggers;
  std::vector<std::string> functions;
};

/// Nothing if the body does something else. `phase`: ico, nba.
std::optional<std::vector<Call>> calls_in(const std::string& body, const std::string& phase) {
  const std::string before = "//Body";
  const auto begin = body.rfind(before);
  if (begin == std::string::npos) return {};
  static const TextPattern If(R"(if\(([^{};]*)\)\{((?:Vrtl___024root___\w+\(vlSelf\);)+)\})"),
      Function(R"(Vrtl___024root___(\w+)\(vlSelf\);)"), Or(R"([|()]*)");
  const TextPattern trigger("vlSelf->__V" + phase + R"(Triggered\.at\(([0-9]+)U\))");
  const auto nothing = [](const auto&) { return std::string(); };
  const std::string statements = body.substr(begin + before.size());
  if (!If.replaced(statements, nothing).empty()) return {};
  std::vector<Call> calls;
  for (const auto& statement : If.all(statements)) {
    if (!Or.matches(trigger.replaced(statement[1], nothing))) return {};
    Call& call = calls.emplace_back();
    for (const auto& number : trigger.all(statement[1])) call.triggers.insert(std::stoi(number[1]));
    for (const auto& name : Function.all(statement[2])) call.functions.push_back(name[1]);
  }
  return calls;
}

/// By which triggers the clock rises and groups are taken.
struct Triggers {
  std::set<int> ticks;
  std::map<int, int> groups;  // by trigger
};

/// Nothing if there are others.
std::optional<Triggers> triggers_in(const std::string& body) {
  const std::string triggered = "vlSelf->__VactTriggered.at(";
  static const std::string Number = R"(vlSelf->__VactTriggered\.at\(([0-9]+)U\)=)",
                           Signal = R"(\(IData\)\(vlSelf->)",
                           Before = R"(\(IData\)\(vlSelf->__Vtrigrprev__TOP__)";
  static const TextPattern Rises(Number + R"(\()" + Signal + R"((\w+__DOT__(\w+_clock))\)&\(~)" +
                                 Before + R"(\2\)\)\))"),
      Changes(Number + R"(\()" + Signal + Take + R"(([0-9]+)\)\^)" + Before + Take + R"(\2\)\))");
  Triggers all;
  bool has_clock = false;
  std::istringstream statements(body);
  for (std::string statement; std::getline(statements, statement, ';');) {
    const auto at = statement.find(triggered);
    if (at == std::string::npos) continue;
    statement = statement.substr(at);
    const auto rises = Rises.match(statement), changes = Changes.match(statement);
    const bool outside = !rises.empty() && rises[2].find("__DOT__") == rises[2].rfind("__DOT__");
    has_clock |= outside && rises[3] == "racebeam_clock";
    if (outside) all.ticks.insert(std::stoi(rises[1]));
    else if (!changes.empty()) all.groups[std::stoi(changes[1])] = std::stoi(changes[2]);
    else return {};
  }
  if (!has_clock) return {};
  return all;
}

}  // namespace

std::optional<DirectSteps> direct_steps(const std::string& folder) {
  std::string text;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".cpp") text += whole_file(entry.path());
  const std::string active = class_body(text, "eval_act");
  if (!only_looks(class_body(text, "eval")) || active.empty() ||
      active.find("Triggered") != std::string::npos)
    return {};
  const auto triggers = triggers_in(class_body(text, "eval_triggers__act"));
  const auto inputs = calls_in(class_body(text, "eval_ico"), "ico");
  const auto registers = calls_in(class_body(text, "eval_nba"), "nba");
  if (!triggers || !inputs || !registers) return {};
  DirectSteps steps;
  for (const Call& call : *inputs)
    steps.inputs.insert(steps.inputs.end(), call.functions.begin(), call.functions.end());
  for (const Call& call : *registers)
    for (const std::string& function : call.functions) {
      DirectStep& step = steps.registers.emplace_back();
      step.function = function;
      for (const int trigger : call.triggers) {
        step.at_tick |= triggers->ticks.count(trigger) != 0;
        if (const auto group = triggers->groups.find(trigger); group != triggers->groups.end())
          step.groups.insert(group->second);
      }
    }
  const auto looks = [&text](const std::string& function) {
    const std::string body = class_body(text, function);
    return body.empty() || body.find("Triggered") != std::string::npos;
  };
  for (const std::string& function : steps.inputs)
    if (looks(function)) return {};
  for (const DirectStep& step : steps.registers)
    if (looks(step.function)) return {};
  find_needless(text, whole_file(folder + "/Vrtl___024root.h"), steps);
  return steps;
}

}  // namespace racebeam
