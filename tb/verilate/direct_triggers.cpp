// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/direct_triggers.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <sstream>

#include "tb/base/text_pattern.h"
#include "tb/base/whole_file.h"
#include "tb/verilate/clock_wrapper.h"

namespace racebeam {

namespace {

/// The body of a function, without blanks; empty if it is not there.
std::string body_of(const std::string& text, const std::string& function) {
  const auto begin = text.find("void Vrtl___024root___" + function + "(Vrtl___024root* vlSelf) {");
  if (begin == std::string::npos) return "";
  std::string body = text.substr(begin, text.find("\n}\n", begin) - begin);
  body.erase(std::remove_if(body.begin(), body.end(),
                            [](unsigned char c) { return std::isspace(c) != 0; }),
             body.end());
  return body;
}

/// Whether eval() does nothing but look for triggers: no values are sampled for properties, say.
bool only_looks(const std::string& body) {
  static const TextPattern Signal(R"(vlSelf->(\w+))"),
      Own("__V(ico|act|nba)(Triggered|IterCount|Continue)|vlSymsp");
  const auto signals = Signal.all(body);
  return !body.empty() && std::all_of(signals.begin(), signals.end(),
                                      [](const auto& signal) { return Own.matches(signal[1]); });
}

}  // namespace

std::optional<DirectTriggers> direct_triggers(const std::string& folder) {
  std::string eval, triggers, active, inputs, registers;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string text = whole_file(entry.path());
    eval += body_of(text, "eval");
    triggers += body_of(text, "eval_triggers__act");
    active += body_of(text, "eval_act");
    inputs += body_of(text, "eval_ico");
    registers += body_of(text, "eval_nba");
  }
  const std::string triggered = "vlSelf->__VactTriggered.at(";
  if (!only_looks(eval) || active.empty() || inputs.empty() || registers.empty() ||
      active.find(triggered) != std::string::npos)
    return {};
  static const std::string Number = R"(vlSelf->__VactTriggered\.at\(([0-9]+)U\)=)",
                           Signal = R"(\(IData\)\(vlSelf->)",
                           Before = R"(\(IData\)\(vlSelf->__Vtrigrprev__TOP__)";
  static const TextPattern Rises(Number + R"(\()" + Signal + R"((\w+__DOT__(\w+_clock))\)&\(~)" +
                                 Before + R"(\2\)\)\))"),
      Changes(Number + R"(\()" + Signal + Take + R"(\)\^)" + Before + Take + R"(\)\))");
  DirectTriggers direct;
  bool has_clock = false;
  std::istringstream statements(triggers);
  for (std::string statement; std::getline(statements, statement, ';');) {
    const auto at = statement.find(triggered);
    if (at == std::string::npos) continue;
    statement = statement.substr(at);
    const auto rises = Rises.match(statement), changes = Changes.match(statement);
    const bool outside = !rises.empty() && rises[2].find("__DOT__") == rises[2].rfind("__DOT__");
    has_clock |= outside && rises[3] == "racebeam_clock";
    if (outside) direct.ticks.push_back(std::stoi(rises[1]));
    else if (!changes.empty() && direct.take < 0) direct.take = std::stoi(changes[1]);
    else return {};
  }
  if (!has_clock) return {};
  return direct;
}

}  // namespace racebeam
