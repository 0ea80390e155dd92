// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/cli/wave.h"

#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace racebeam {

namespace {

void need(bool good, const std::string& what) {
  if (!good) throw std::runtime_error("VCD: " + what);
}

}  // namespace

std::string Wave::Signal::at(std::uint64_t time) const {
  const auto next = changes.upper_bound(time);
  return next == changes.begin() ? "" : std::prev(next)->second;
}

std::uint64_t Wave::Signal::number(std::uint64_t time) const {
  return std::stoull(at(time), nullptr, 2);
}

bool Wave::Signal::operator==(const Signal& other) const {
  return bits == other.bits && kind == other.kind && changes == other.changes;
}

Wave::Wave(const std::string& path, bool ours) {
  std::ifstream in(path);
  need(in.good(), "no file " + path);
  std::string scope;
  bool declared = false;
  std::uint64_t time = 0;
  bool timed = false, dumps = false, dumped = !ours;
  std::size_t changes = 0;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::vector<std::string> w{std::istream_iterator<std::string>(words), {}};
    if (w.empty()) continue;
    if (!declared) {
      declared = declare(w, scope);
    } else if (w[0][0] == '#') {
      const std::uint64_t next = std::stoull(w[0].substr(1));
      need(!timed || next > time, "time goes back at " + line);
      time = end = next;
      if (!timed) begin = time;
      timed = true;
    } else if (w[0] == "$dumpvars") {
      need(timed && time == begin && changes == 0, "$dumpvars after a change");
      dumps = true;
    } else if (w[0] == "$end") {
      need(dumps && time == begin, "$end");
      dumps = false;
      dumped = true;
    } else {
      need(timed, "a change before the first time");
      need(dumps || dumped, "a change before $dumpvars");
      ++changes;
      change(w, time);
    }
  }
  need(declared, "no $enddefinitions");
  need(!dumps, "$dumpvars without $end");
  for (const auto& [name, code] : codes_) signals[name] = by_code_.at(code);
}

const Wave::Signal& Wave::operator[](const std::string& path) const {
  const auto at = signals.find(path);
  need(at != signals.end(), "no signal " + path);
  return at->second;
}

bool Wave::declare(const std::vector<std::string>& w, std::string& scope) {
  if (w[0] == "$enddefinitions") {
    need(scope.empty(), "a scope is open: " + scope);
    return true;
  }
  if (w[0] == "$timescale") {
    for (std::size_t n = 1; n + 1 < w.size(); ++n) scale += w[n];
  } else if (w[0] == "$scope") {
    scope += w.at(2) + ".";
  } else if (w[0] == "$upscope") {
    need(!scope.empty(), "$upscope");
    const auto dot = scope.rfind('.', scope.size() - 2);
    scope.erase(dot == std::string::npos ? 0 : dot + 1);
  } else if (w[0] == "$var") {
    const int bits = std::stoi(w.at(2));
    need(w.back() == "$end" && w.size() >= 6, "a $var of " + std::to_string(w.size()) + " words");
    need(codes_.emplace(scope + w[4], w[3]).second, "twice: " + scope + w[4]);
    Signal& signal = by_code_[w[3]];
    need(signal.bits == 0 || signal.bits == bits, "two widths of " + scope + w[4]);
    signal.bits = bits;
    signal.kind = w[1];
  }
  return false;
}

void Wave::change(const std::vector<std::string>& w, std::uint64_t time) {
  const bool vector = w[0][0] == 'b' || w[0][0] == 's';
  need(w.size() == (vector ? 2u : 1u), "a change of " + std::to_string(w.size()) + " words");
  const auto at = by_code_.find(vector ? w[1] : w[0].substr(1));
  need(at != by_code_.end(), "an unknown code in " + w[0]);
  Signal& signal = at->second;
  std::string value = vector ? w[0].substr(1) : w[0].substr(0, 1);
  if (w[0][0] != 's') {
    need(value.find_first_not_of("01") == std::string::npos, "digits of " + w[0]);
    need(static_cast<int>(value.size()) <= signal.bits, "too many digits: " + w[0]);
    value.insert(0, static_cast<std::size_t>(signal.bits) - value.size(), '0');
  }
  signal.changes[time] = value;
}

}  // namespace racebeam
