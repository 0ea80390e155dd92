// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/port_stream.h"

#include <fmt/format.h>

#include <algorithm>

#include "sc/base/unit.h"
#include "tb/base/reset_value.h"

namespace racebeam {

bool PortStream::moves(std::size_t input) const {
  for (std::uint64_t clock = 2; clock < clocks(); ++clock)
    if (at(clock, input) != at(1, input)) return true;
  return false;
}

std::size_t PortStream::moving() const {
  std::size_t count = 0;
  for (std::size_t input = 0; input < inputs.size(); ++input) count += moves(input);
  return count;
}

void PortStream::cut(std::uint64_t clocks) {
  values.resize(std::min<std::size_t>(values.size(), clocks * inputs.size()));
  seeks.erase(seeks.lower_bound(clocks), seeks.end());
}

PortStream PortStream::without(std::uint64_t from, std::uint64_t to) const {
  PortStream less{unit, counts_frames, inputs, {}, {}, {}};
  const auto place = [&](std::uint64_t clock) {
    return values.begin() + static_cast<std::ptrdiff_t>(clock * inputs.size());
  };
  less.values.reserve(values.size());
  less.values.insert(less.values.end(), values.begin(), place(from));
  less.values.insert(less.values.end(), place(to), values.end());
  for (const auto& [clock, frame] : seeks)  // of two at one clock the later one counts
    less.seeks[clock < from ? clock : clock < to ? from : clock - (to - from)] = frame;
  less.seeks.erase(less.seeks.lower_bound(less.clocks()), less.seeks.end());
  return less;
}

void PortStream::begin_in_reset() {
  for (std::size_t input = 0; input < inputs.size(); ++input)
    at(0, input) = inputs[input].reset >= 0 ? static_cast<std::uint64_t>(inputs[input].reset)
                                            : inputs[input].rest;
}

PortStream stream_of(const PortTraffic& ports, const LegalInputs& legal) {
  PortStream stream;
  stream.unit = ports.unit;
  for (const PortTraffic::Port& port : ports.ports) {
    if (!port.input) continue;
    const int reset = reset_value(port.name);
    stream.inputs.push_back({port.name, port.bits, reset,
                             reset >= 0 ? static_cast<std::uint64_t>(1 - reset)
                                        : raw_bits(legal.of(port.name, 0), port.bits)});
  }
  return stream;
}

namespace {

std::string clocks_text(const PortStream& stream) {
  std::string text;
  std::vector<std::size_t> moving;
  for (std::size_t input = 0; input < stream.inputs.size(); ++input) {
    if (stream.moves(input)) moving.push_back(input);
    else if (stream.clocks() > 1 && stream.at(1, input) != stream.inputs[input].rest)
      text += fmt::format("hold {} {:x}\n", stream.inputs[input].name, stream.at(1, input));
  }
  text += fmt::format("{:<9}", "clock");
  for (const std::size_t input : moving) text += " " + stream.inputs[input].name;
  text += "\n";
  const auto alike = [&](std::uint64_t one, std::uint64_t other) {
    return stream.seeks.count(other) == 0 &&
           std::all_of(moving.begin(), moving.end(), [&](std::size_t input) {
             return stream.at(one, input) == stream.at(other, input);
           });
  };
  for (std::uint64_t clock = 1; clock < stream.clocks();) {
    std::uint64_t end = clock + 1;
    while (end < stream.clocks() && alike(clock, end)) ++end;
    if (const auto seek = stream.seeks.find(clock); seek != stream.seeks.end())
      text += fmt::format("frame {}\n", seek->second);
    text += fmt::format(
        "{:<9}", end == clock + 1 ? std::to_string(clock) : fmt::format("{}..{}", clock, end - 1));
    for (const std::size_t input : moving)
      text += fmt::format(" {:>{}x}", stream.at(clock, input), stream.inputs[input].name.size());
    text += "\n";
    clock = end;
  }
  return text;
}

}  // namespace

std::string stream_head(const std::string& unit, const std::vector<std::string>& comment) {
  std::string text = "# racebeam-stream 1\n";
  for (const std::string& line : comment) text += "# " + line + "\n";
  return text + "unit " + unit + "\n";
}

std::string episode_text(const PortStream& stream, const std::string& comment) {
  return "\nepisode  # " + comment + "\n" + clocks_text(stream);
}

std::string stream_text(const PortStream& stream, const std::vector<std::string>& comment) {
  return stream_head(stream.unit, comment) + clocks_text(stream);
}

}  // namespace racebeam
