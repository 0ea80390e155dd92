// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/wave/vcd_diff.h"

#include <algorithm>
#include <utility>

#include "tb/base/errors.h"
#include "tb/wave/signal_look.h"

namespace racebeam {

namespace {

struct Pair {
  std::string path;
  int a, b;
};
using Pairs = std::vector<std::vector<Pair>>;  // by signal

/// A file on the time axis of both.
class Side {
 public:
  Side(VcdReader& reader, std::uint64_t unit) : reader_(reader), factor_(reader.unit() / unit) {}

  std::optional<std::uint64_t> next() const {
    const std::optional<std::uint64_t> time = reader_.next_time();
    std::uint64_t scaled = 0;
    if (time && __builtin_mul_overflow(*time, factor_, &scaled))
      throw UsageError(reader_.name() + ": the time " + std::to_string(*time) +
                       " is too far away in the other file's unit");
    return time ? std::optional(scaled) : std::nullopt;
  }
  /// Appends the pairs that change at `time` to `moved`. The count of such signals.
  std::uint64_t step(std::uint64_t time, const Pairs& pairs, std::vector<const Pair*>& moved) {
    if (next() != time) return 0;
    std::uint64_t changes = 0;
    const std::vector<int>& changed = reader_.advance();
    over_ = changed.empty() && !reader_.next_time();
    for (const int signal : changed) {
      const auto at = static_cast<std::size_t>(signal);
      if (at >= pairs.size() || pairs[at].empty()) continue;
      ++changes;
      for (const Pair& pair : pairs[at]) moved.push_back(&pair);
    }
    return changes;
  }
  /// The last time had no changes: there the values end.
  bool over() const { return over_; }

 private:
  VcdReader& reader_;
  const std::uint64_t factor_;
  bool over_ = false;
};

std::string time_text(std::uint64_t time, std::uint64_t unit) {
  const char* const names[] = {" fs", " ps", " ns", " us", " ms", " s"};
  std::size_t name = 0;
  for (; unit >= 1000; unit /= 1000) ++name;
  return std::to_string(time) + (unit == 100 ? "00" : unit == 10 ? "0" : "") + names[name];
}

std::string shown(const VcdReader& vcd, int signal, const std::string& path) {
  const std::string name = path.substr(path.rfind('.') + 1);
  const int bits = vcd.bits(signal);
  return formatted(vcd.value(signal), format_of(name, bits), bits);
}

/// Where the beam is, from the signals of the trace.
std::string place_of(const VcdReader& vcd) {
  std::string text;
  for (const char* name : {"frame", "line", "clock"}) {
    const auto at = vcd.signals().find(std::string("beam.") + name);
    if (at == vcd.signals().end() || vcd.value(at->second).empty()) return "";
    text +=
        (text.empty() ? "" : ", ") + std::string(name) + " " + shown(vcd, at->second, at->first);
  }
  return text;
}

/// Two values that differ, but look alike as numbers, are shown by their digits.
VcdDifference::Row row_of(const Pair& pair, const VcdReader& a, const VcdReader& b) {
  VcdDifference::Row row{pair.path, shown(a, pair.a, pair.path), shown(b, pair.b, pair.path)};
  if (row.a == row.b) row = {pair.path, a.value(pair.a), b.value(pair.b)};
  for (std::string* value : {&row.a, &row.b})
    if (value->empty()) *value = "unknown";
  return row;
}

std::vector<VcdDifference::Row> rows_of(const std::vector<const Pair*>& moved, const VcdReader& a,
                                        const VcdReader& b) {
  std::vector<VcdDifference::Row> rows;
  for (const Pair* pair : moved)
    if (a.value(pair->a) != b.value(pair->b)) rows.push_back(row_of(*pair, a, b));
  std::sort(rows.begin(), rows.end(), [](const auto& x, const auto& y) { return x.path < y.path; });
  rows.erase(std::unique(rows.begin(), rows.end(),
                         [](const auto& x, const auto& y) { return x.path == y.path; }),
             rows.end());
  return rows;
}

/// The paths of both, by signal of each.
struct Paired {
  Pairs of_a, of_b;
};

Paired pair_up(const VcdReader& a, const VcdReader& b,
               const std::function<bool(const std::string&)>& takes, VcdComparison& result) {
  Paired paired{Pairs(a.paths().size()), Pairs(b.paths().size())};
  const auto find = [](const VcdReader& vcd, const std::string& path, int bits) {
    const auto at = vcd.signals().find(path);
    return at == vcd.signals().end() || vcd.bits(at->second) != bits ? -1 : at->second;
  };
  for (const auto& [path, signal] : a.signals()) {
    if (!takes(path)) continue;
    const int other = find(b, path, a.bits(signal));
    if (other < 0) {
      result.only_a.push_back(path);
      continue;
    }
    paired.of_a[static_cast<std::size_t>(signal)].push_back({path, signal, other});
    paired.of_b[static_cast<std::size_t>(other)].push_back({path, signal, other});
    ++result.shared;
  }
  for (const auto& [path, signal] : b.signals())
    if (takes(path) && find(a, path, b.bits(signal)) < 0) result.only_b.push_back(path);
  return paired;
}

}  // namespace

VcdComparison compare_vcds(VcdReader& a, VcdReader& b,
                           const std::function<bool(const std::string&)>& takes) {
  VcdComparison result;
  const Paired paired = pair_up(a, b, takes, result);
  const std::uint64_t unit = std::min(a.unit(), b.unit());
  Side side_a(a, unit), side_b(b, unit);
  const auto need_both = [&] {
    if (!side_a.next() || !side_b.next())
      throw UsageError("the two files have no time in common: " + a.name() + ", " + b.name());
  };
  need_both();
  result.begin_a = time_text(*side_a.next(), unit);
  result.begin_b = time_text(*side_b.next(), unit);
  std::uint64_t time = std::max(*side_a.next(), *side_b.next());
  std::vector<const Pair*> moved, all;
  for (Side* side : {&side_a, &side_b})
    while (side->next() && *side->next() < time) side->step(*side->next(), {}, moved);
  need_both();
  for (const auto& pairs : paired.of_a)
    for (const Pair& pair : pairs) all.push_back(&pair);

  for (bool is_first = true;; is_first = false) {
    const std::uint64_t changes = side_a.step(time, paired.of_a, moved);
    side_b.step(time, paired.of_b, moved);
    if (side_a.over() || side_b.over()) break;
    result.changes += changes;
    if (auto rows = rows_of(is_first ? all : moved, a, b); !rows.empty()) {
      result.first = {time_text(time, unit), place_of(a), std::move(rows)};
      return result;
    }
    moved.clear();
    if (!side_a.next() || !side_b.next()) break;
    time = std::min(*side_a.next(), *side_b.next());
  }
  while (side_a.next() && moved.empty()) side_a.step(*side_a.next(), paired.of_a, moved);
  while (side_b.next() && moved.empty()) side_b.step(*side_b.next(), paired.of_b, moved);
  if (!moved.empty()) result.end = time_text(time, unit);
  return result;
}

}  // namespace racebeam
