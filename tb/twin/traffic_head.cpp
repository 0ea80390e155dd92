// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/traffic_head.h"

#include <fmt/format.h>

#include <map>
#include <sstream>
#include <stdexcept>

namespace racebeam {

namespace {

constexpr int WidestPort = 64;

/// The texts of a head, by the word that a line begins with.
std::map<std::string, std::string*> texts_of(TrafficHead& head) {
  return {{"program", &head.program}, {"unit", &head.unit},       {"engine", &head.engine},
          {"scene", &head.scene},     {"hash", &head.scene_hash}, {"source", &head.source}};
}

PortTraffic::Port port_of(const std::string& text) {
  std::istringstream words(text);
  PortTraffic::Port port{};
  std::string way, more;
  if (!(words >> way >> port.bits >> port.name) || (way != "input" && way != "output") ||
      port.bits < 1 || port.bits > WidestPort)
    throw std::runtime_error("'port " + text + "' is no port");
  port.input = way == "input";
  port.optional = static_cast<bool>(words >> more) && more == "optional";
  return port;
}

}  // namespace

std::string head_text(const TrafficHead& head) {
  std::string text = fmt::format("{} {}\n", TrafficMagic, TrafficVersion);
  TrafficHead copy = head;
  for (const auto& [word, to] : texts_of(copy)) text += word + " " + *to + "\n";
  for (const auto& [name, value] : head.knobs) text += fmt::format("knob {} {}\n", name, value);
  for (const PortTraffic::Port& port : head.ports)
    text += fmt::format("port {} {} {}{}\n", port.input ? "input" : "output", port.bits, port.name,
                        port.optional ? " optional" : "");
  return text + TrafficHeadEnd;
}

TrafficHead head_of(const std::string& text) {
  std::istringstream lines(text);
  std::string line, magic;
  int version = 0;
  std::getline(lines, line);
  if (!(std::istringstream(line) >> magic >> version) || magic != TrafficMagic)
    throw std::runtime_error("it holds no port traffic");
  if (version != TrafficVersion)
    throw std::runtime_error(fmt::format("its format is version {}, and this program reads {}",
                                         version, TrafficVersion));
  TrafficHead head;
  const auto texts = texts_of(head);
  while (std::getline(lines, line) && line + "\n" != TrafficHeadEnd) {
    const auto blank = line.find(' ');
    const std::string word = line.substr(0, blank),
                      rest = blank == std::string::npos ? "" : line.substr(blank + 1);
    if (const auto text_of = texts.find(word); text_of != texts.end()) {
      *text_of->second = rest;
    } else if (word == "port") {
      head.ports.push_back(port_of(rest));
    } else if (word == "knob") {
      std::istringstream words(rest);
      std::string name;
      int value = 0;
      if (!(words >> name >> value)) throw std::runtime_error("'" + line + "' is no knob");
      head.knobs.emplace_back(name, value);
    } else {
      throw std::runtime_error("its head has an unknown line '" + line + "'");
    }
  }
  if (head.ports.empty()) throw std::runtime_error("its head has no ports");
  return head;
}

}  // namespace racebeam
