// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/vcd_writer.h"

#include <algorithm>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace racebeam {

namespace {

/// Identifier code: printable characters, the shortest first.
std::string code(int signal) {
  constexpr int First = '!', Codes = '~' - '!' + 1;
  std::string text;
  for (; signal >= 0; signal = signal / Codes - 1)
    text += static_cast<char>(First + signal % Codes);
  return text;
}

std::vector<std::string> parts(const std::string& scope) {
  std::vector<std::string> names;
  std::istringstream in(scope);
  for (std::string name; std::getline(in, name, '.');) names.push_back(name);
  return names;
}

/// Leaves the scopes of `from` that are not of `to`, and enters the others.
std::string move(const std::vector<std::string>& from, const std::vector<std::string>& to) {
  std::size_t same = 0;
  while (same < from.size() && same < to.size() && from[same] == to[same]) ++same;
  std::string text;
  for (std::size_t n = same; n < from.size(); ++n) text += "$upscope $end\n";
  for (std::size_t n = same; n < to.size(); ++n) text += "$scope module " + to[n] + " $end\n";
  return text;
}

}  // namespace

int VcdWriter::add(const std::string& scope, const std::string& name, int bits) {
  if (bits < 1 || bits > 64) throw std::invalid_argument(name + ": a signal has 1 to 64 bits");
  if (started_) throw std::logic_error(name + " comes after the first change");
  signals_.push_back({scope, name, bits});
  return static_cast<int>(signals_.size()) - 1;
}

void VcdWriter::change(std::uint64_t time, int signal, std::uint64_t value) {
  Signal& s = signals_.at(static_cast<std::size_t>(signal));
  if (time < time_) throw std::logic_error("the time of " + s.name + " runs backwards");
  if (s.known && s.value == value) return;
  s.known = true;
  s.value = value;
  if (time > time_ || !started_) changes_ += "#" + std::to_string(time) + "\n";
  started_ = true;
  time_ = time;
  if (s.bits == 1) {
    changes_ += (value & 1 ? "1" : "0") + code(signal) + "\n";
    return;
  }
  std::string digits;
  for (int bit = s.bits - 1; bit >= 0; --bit) digits += (value >> bit & 1) ? '1' : '0';
  changes_ += "b" + digits + " " + code(signal) + "\n";
}

std::string VcdWriter::text(const std::string& comment, std::uint64_t end) const {
  std::vector<int> order(signals_.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return signals_[static_cast<std::size_t>(a)].scope <
           signals_[static_cast<std::size_t>(b)].scope;
  });
  std::string text = "$comment " + comment + " $end\n$timescale 1 ps $end\n";
  std::vector<std::string> at;
  for (const int n : order) {
    const Signal& s = signals_[static_cast<std::size_t>(n)];
    const auto to = parts(s.scope);
    text += move(at, to);
    at = to;
    text += "$var wire " + std::to_string(s.bits) + " " + code(n) + " " + s.name +
            (s.bits > 1 ? " [" + std::to_string(s.bits - 1) + ":0]" : "") + " $end\n";
  }
  text += move(at, {}) + "$enddefinitions $end\n" + changes_;
  if (end > time_) text += "#" + std::to_string(end) + "\n";
  return text;
}

}  // namespace racebeam
