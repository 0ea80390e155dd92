// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/clock_wrapper.h"

namespace racebeam {

namespace {

constexpr const char* Clock = "racebeam_clock";

void append(std::string& list, const std::string& item) {
  list += (list.empty() ? "\n  " : ",\n  ") + item;
}

/// The clock rises with the tick, and falls by itself as soon as all registers have seen that.
std::string pulse() {
  const std::string seen = std::string(Tick) + "_q", clock = Clock;
  return "reg " + seen + " = 0;\nwire " + clock + " = " + Tick + " ^ " + seen +
         ";\nalways @(posedge " + clock + ") " + seen + " <= " + Tick + ";\n";
}

}  // namespace

bool is_wrapped(const RtlSources& sources, const RtlSyntax& syntax) {
  return syntax.rising_only || (sources.kind == RtlSources::Chip && !syntax.clock.empty());
}

std::string clock_wrapper(const RtlSources& sources, const RtlSyntax& syntax) {
  const std::string clock = syntax.rising_only ? Clock : syntax.clock;
  std::string ports, registers, pins, parameters;
  if (syntax.rising_only) append(ports, std::string("input wire ") + Tick);
  for (const RtlSyntax::Port& port : syntax.ports) {
    if (port.name == syntax.clock) {
      append(pins, "." + port.name + "(" + clock + ")");
      if (!syntax.rising_only) append(ports, "input wire " + port.name);
      continue;
    }
    const std::string declared = " [" + std::to_string(port.bits - 1) + ":0] " + port.name;
    append(ports, port.direction + " wire" + declared);
    const bool held = sources.kind == RtlSources::Chip && port.direction == "input";
    append(pins, "." + port.name + "(" + port.name + (held ? "_q)" : ")"));
    if (held)
      registers += "reg" + declared + "_q;\nalways @(posedge " + clock + ") " + port.name +
                   "_q <= " + port.name + ";\n";
  }
  for (const std::string& parameter : sources.parameters) {
    const auto equals = parameter.find('=');
    append(parameters,
           "." + parameter.substr(0, equals) + "(" + parameter.substr(equals + 1) + ")");
  }
  return std::string("module ") + Wrapper + " (" + ports + ");\n" +
         (syntax.rising_only ? pulse() : "") + registers + syntax.top.name +
         (parameters.empty() ? "" : " #(" + parameters + ")") + " " + Wrapped + " (" + pins +
         ");\nendmodule\n";
}

}  // namespace racebeam
