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
  const std::string seen = TickSeen, clock = Clock;
  return "reg " + seen + " = 0;\nwire " + clock + " = " + Tick + " ^ " + seen +
         ";\nalways @(posedge " + clock + ") " + seen + " <= " + Tick + ";\n";
}

/// A register NAME_q that takes NAME when `event` happens.
std::string copies(const std::string& declared, const std::string& name, const std::string& begin,
                   const std::string& event) {
  return "reg" + declared + "_q" + begin + ";\nalways @(" + event + ") " + name + "_q <= " + name +
         ";\n";
}

/// Writes what comes through the doors, with what else is taken.
std::string door_text(const std::vector<std::string>& doors) {
  std::string text;
  for (std::size_t n = 0; n < doors.size(); ++n) {
    const std::string number = std::to_string(n);
    text += std::string("if (") + Knock + "[" + number + "]) " + Wrapped + "." + doors[n] +
            " <= " + Door + number + ";\n";
  }
  return text;
}

const std::string Moves = std::string("posedge ") + Take + " or negedge " + Take;

}  // namespace

bool is_wrapped(const RtlSources& sources, const RtlSyntax& syntax) {
  return syntax.rising_only || (sources.kind == RtlSources::Chip && !syntax.clock.empty());
}

std::set<std::string> taken_inputs(const RtlSources& sources, const RtlSyntax& syntax,
                                   const std::set<std::string>& quiet) {
  std::set<std::string> taken;
  if (sources.kind == RtlSources::Chip || !syntax.rising_only || sources.coverage ||
      (syntax.speaks_between_edges && sources.doors.empty()))
    return taken;
  for (const RtlSyntax::Port& port : syntax.ports)
    if (port.direction == "input" && port.name != syntax.clock && quiet.count(port.name) == 0)
      taken.insert(port.name);
  return taken;
}

std::string clock_wrapper(const RtlSources& sources, const RtlSyntax& syntax,
                          const std::set<std::string>& taken) {
  const std::string clock = syntax.rising_only ? Clock : syntax.clock;
  std::string ports, registers, pins, parameters;
  if (syntax.rising_only) append(ports, std::string("input wire ") + Tick);
  if (!taken.empty()) append(ports, std::string("input wire ") + Take);
  if (!sources.doors.empty()) append(ports, std::string("input wire [31:0] ") + Knock);
  for (std::size_t n = 0; n < sources.doors.size(); ++n)
    append(ports, "input wire [63:0] " + (Door + std::to_string(n)));
  for (const RtlSyntax::Port& port : syntax.ports) {
    if (port.name == syntax.clock) {
      append(pins, "." + port.name + "(" + clock + ")");
      if (!syntax.rising_only) append(ports, "input wire " + port.name);
      continue;
    }
    const std::string declared = " [" + std::to_string(port.bits - 1) + ":0] " + port.name;
    append(ports, port.direction + " wire" + declared);
    const bool at_edge = sources.kind == RtlSources::Chip && port.direction == "input";
    const bool held = at_edge || taken.count(port.name) != 0;
    append(pins, "." + port.name + "(" + port.name + (held ? "_q)" : ")"));
    if (at_edge) registers += copies(declared, port.name, "", "posedge " + clock);
    else if (held) registers += copies(declared, port.name, " = 0", Moves);
  }
  for (const std::string& parameter : sources.parameters) {
    const auto equals = parameter.find('=');
    append(parameters,
           "." + parameter.substr(0, equals) + "(" + parameter.substr(equals + 1) + ")");
  }
  return std::string("module ") + Wrapper + " (" + ports + ");\n" +
         (syntax.rising_only ? pulse() : "") + registers + syntax.top.name +
         (parameters.empty() ? "" : " #(" + parameters + ")") + " " + Wrapped + " (" + pins +
         ");\n" +
         (sources.doors.empty()
              ? ""
              : "always @(" + Moves + ") begin\n" + door_text(sources.doors) + "end\n") +
         "endmodule\n";
}

}  // namespace racebeam
