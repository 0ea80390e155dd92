// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/trace/vcd_diff.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace racebeam {

namespace {

struct Pair {
  std::string path;
  int a, b;
};

/// Digits as a signed number of that width.
std::string number(const std::string& digits, int bits) {
  if (digits.empty() || digits.size() > 64 || digits.find_first_not_of("01") != std::string::npos)
    return "?";
  long long value = std::stoll(digits, nullptr, 2);
  if (digits.size() == static_cast<std::size_t>(bits) && digits[0] == '1') value -= 1LL << bits;
  return std::to_string(value);
}

/// Where the beam is, from the signals of the trace.
std::string place_of(const VcdReader& vcd) {
  std::string text;
  for (const char* name : {"frame", "line", "clock"}) {
    const auto at = vcd.signals().find(std::string("beam.") + name);
    if (at == vcd.signals().end()) return "";
    const bool is_line = std::string(name) == "line";
    text += (text.empty() ? "" : ", ") + std::string(name) + " " +
            number(vcd.value(at->second), is_line ? vcd.bits(at->second) : 64);
  }
  return text;
}

}  // namespace

VcdComparison compare_vcds(VcdReader& a, VcdReader& b) {
  VcdComparison result;
  std::vector<std::vector<Pair>> of_a, of_b;  // by signal
  for (const auto& [path, signal] : a.signals()) {
    const auto other = b.signals().find(path);
    if (other == b.signals().end() || b.bits(other->second) != a.bits(signal)) {
      result.only_a.push_back(path);
      continue;
    }
    const auto index = [](int n) { return static_cast<std::size_t>(n); };
    of_a.resize(std::max(of_a.size(), index(signal) + 1));
    of_b.resize(std::max(of_b.size(), index(other->second) + 1));
    of_a[index(signal)].push_back({path, signal, other->second});
    of_b[index(other->second)].push_back({path, signal, other->second});
    ++result.shared;
  }
  for (const auto& [path, signal] : b.signals()) {
    const auto other = a.signals().find(path);
    if (other == a.signals().end() || a.bits(other->second) != b.bits(signal))
      result.only_b.push_back(path);
  }

  constexpr auto Never = std::numeric_limits<std::uint64_t>::max();
  while (a.next_time() || b.next_time()) {
    const std::uint64_t time =
        std::min(a.next_time().value_or(Never), b.next_time().value_or(Never));
    std::vector<VcdDifference::Row> rows;
    std::vector<const Pair*> moved;
    const auto step = [&](VcdReader& reader, const std::vector<std::vector<Pair>>& pairs) {
      if (reader.next_time() != time) return;
      for (const int signal : reader.advance()) {
        if (static_cast<std::size_t>(signal) >= pairs.size()) continue;
        const auto& compared = pairs[static_cast<std::size_t>(signal)];
        result.changes += &reader == &a && !compared.empty();
        for (const Pair& pair : compared) moved.push_back(&pair);
      }
    };
    step(a, of_a);
    step(b, of_b);
    for (const Pair* pair : moved)
      if (a.value(pair->a) != b.value(pair->b))
        rows.push_back({pair->path, a.value(pair->a), b.value(pair->b)});
    if (rows.empty()) continue;
    std::sort(rows.begin(), rows.end(),
              [](const auto& x, const auto& y) { return x.path < y.path; });
    rows.erase(std::unique(rows.begin(), rows.end(),
                           [](const auto& x, const auto& y) { return x.path == y.path; }),
               rows.end());
    const std::string place = place_of(a);
    result.first = {time, place, std::move(rows)};
    return result;
  }
  return result;
}

}  // namespace racebeam
