// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/clock_wrapper.h"

#include <algorithm>
#include <map>

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

/// When a group is taken.
std::string moves(int group) {
  const std::string take = Take + std::to_string(group);
  return "posedge " + take + " or negedge " + take;
}

int count_of(const CombGroups& taken) {
  int count = 0;
  for (const auto& [name, group] : taken) count = std::max(count, group + 1);
  return count;
}

}  // namespace

bool is_wrapped(const RtlSources& sources, const RtlSyntax& syntax) {
  return syntax.rising_only || (sources.kind == RtlSources::Chip && !syntax.clock.empty());
}

CombGroups taken_inputs(const RtlSources& sources, const RtlSyntax& syntax,
                        const CombGroups& groups) {
  CombGroups taken;
  if (sources.kind == RtlSources::Chip || !syntax.rising_only || sources.coverage ||
      (syntax.speaks_between_edges && sources.doors.empty()))
    return taken;
  std::map<int, int> numbers;
  for (const RtlSyntax::Port& port : syntax.ports)
    if (const auto at = groups.find(port.name); port.direction == "input" && at != groups.end())
      taken[port.name] =
          numbers.emplace(at->second, std::min(static_cast<int>(numbers.size()), MostGroups - 1))
              .first->second;
  return taken;
}

std::string clock_wrapper(const RtlSources& sources, const RtlSyntax& syntax,
                          const CombGroups& taken) {
  const std::string clock = syntax.rising_only ? Clock : syntax.clock;
  std::string ports, outputs, registers, pins, parameters;
  if (syntax.rising_only) append(ports, std::string("input wire ") + Tick);
  for (int group = 0; group < count_of(taken); ++group)
    append(ports, "input wire " + (Take + std::to_string(group)));
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
    append(port.direction == "input" ? ports : outputs, port.direction + " wire" + declared);
    const bool at_edge = sources.kind == RtlSources::Chip && port.direction == "input";
    const bool held = at_edge || taken.count(port.name) != 0;
    append(pins, "." + port.name + "(" + port.name + (held ? "_q)" : ")"));
    if (at_edge) registers += copies(declared, port.name, "", "posedge " + clock);
    else if (held) registers += copies(declared, port.name, " = 0", moves(taken.at(port.name)));
  }
  for (const std::string& parameter : sources.parameters) {
    const auto equals = parameter.find('=');
    append(parameters,
           "." + parameter.substr(0, equals) + "(" + parameter.substr(equals + 1) + ")");
  }
  if (!outputs.empty()) ports += "," + outputs;  // side by side, as they are looked at together
  return std::string("module ") + Wrapper + " (" + ports + ");\n" +
         (syntax.rising_only ? pulse() : "") + registers + syntax.top.name +
         (parameters.empty() ? "" : " #(" + parameters + ")") + " " + Wrapped + " (" + pins +
         ");\n" +
         (sources.doors.empty()
              ? ""
              : "always @(" + moves(0) + ") begin\n" + door_text(sources.doors) + "end\n") +
         "endmodule\n";
}

}  // namespace racebeam
