// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/lockstep_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "sc/base/constants.h"
#include "tb/base/counted.h"
#include "tb/base/reset_value.h"
#include "tb/base/text_pattern.h"
#include "tb/twin/lockstep_condition.h"

namespace racebeam {

namespace {

using Difference = LockstepDifference;

constexpr std::size_t MostColumns = 16, ShownAfter = 4;

/// Rows of the history that are equal.
struct Fold {
  std::size_t first, last;
};

/// The last ones, up to some clocks after the difference, which stands alone.
std::vector<Fold> folds_of(const Difference& d) {
  std::vector<Fold> folds;
  const std::size_t last = std::min(d.before + ShownAfter, d.history.size() - 1);
  for (std::size_t row = last + 1; row-- > 0;) {
    const bool joins = !folds.empty() && row != d.before && folds.back().first != d.before &&
                       d.history[row] == d.history[folds.back().first];
    if (joins) folds.back().first = row;
    else if (folds.size() == MostColumns) break;
    else folds.push_back({row, row});
  }
  std::reverse(folds.begin(), folds.end());
  return folds;
}

/// "-40..-32", "-1", "0", "+1": against the difference.
std::string clock_text(const Difference& d, const Fold& fold) {
  const auto text = [&](std::size_t row) {
    const auto clock = static_cast<long long>(row) - static_cast<long long>(d.before);
    return clock > 0 ? fmt::format("+{}", clock) : std::to_string(clock);
  };
  return text(fold.first) + (fold.first == fold.last ? "" : ".." + text(fold.last));
}

/// Whether the outputs were compared in a row: not in the first clock of all.
bool compared(const Difference& d, std::size_t row) { return d.first_clock() + row > 0; }

/// A line of the table.
using Cells = std::vector<std::string>;

/// Two sides of an output, the model's at `column`.
class Sides {
 public:
  Sides(const Difference& d, std::size_t column)
      : d_(d), model_(column), mask_(raw_bits(~std::uint64_t{0}, d.columns[column].bits)) {}

  const std::string& port() const { return d_.columns[model_].port; }
  int bits() const { return d_.columns[model_].bits; }
  std::uint64_t mask() const { return mask_; }
  std::uint64_t model(std::size_t row) const { return d_.history[row][model_] & mask_; }
  std::uint64_t rtl(std::size_t row) const { return d_.history[row][model_ + 1] & mask_; }
  bool differ(std::size_t row) const { return compared(d_, row) && model(row) != rtl(row); }

 private:
  const Difference& d_;
  const std::size_t model_;
  const std::uint64_t mask_;
};

/// All outputs.
std::vector<Sides> outputs_of(const Difference& d) {
  std::vector<Sides> all;
  for (std::size_t n = 0; n < d.columns.size(); ++n)
    if (d.columns[n].side == Difference::Model) all.emplace_back(d, n);
  return all;
}

std::string hex(std::uint64_t value, int bits) {
  return fmt::format("{:x}", raw_bits(value, bits));
}

/// The values of both sides of a port from the difference on.
struct Course {
  int model_changes = 0, rtl_changes = 0, differing = 0;
  std::uint64_t bits = 0;
  bool late, early = true, inverted = true;

  Course(const Difference& d, const Sides& port) : late(d.before > 0) {
    for (std::size_t row = d.before; row < d.history.size(); ++row) {
      if (row > 0) {
        model_changes += port.model(row) != port.model(row - 1);
        rtl_changes += port.rtl(row) != port.rtl(row - 1);
        late = late && port.rtl(row) == port.model(row - 1);
      }
      if (row + 1 < d.history.size()) early = early && port.rtl(row) == port.model(row + 1);
      inverted = inverted && port.rtl(row) == (~port.model(row) & port.mask());
      differing += port.differ(row);
      bits |= port.model(row) ^ port.rtl(row);
    }
  }
  bool one_bit() const { return differing > 1 && (bits & (bits - 1)) == 0; }
};

/// What that proves, or nothing. Too few changes prove nothing.
std::string course_text(const Difference& d, const Sides& port) {
  constexpr int Enough = 3;
  const Course c(d, port);
  const std::size_t clocks = d.history.size() - d.before;
  const std::string &name = port.port(),
                    seen = counted(clocks, "clock") + " from the difference on";
  if (c.late && c.model_changes >= Enough)
    return fmt::format(
        "the RTL is one clock late: in {} its {} is the model's of one clock before, through {}",
        seen, name, counted(c.model_changes, "change"));
  if (c.early && c.rtl_changes >= Enough)
    return fmt::format(
        "the RTL is one clock early: in {} from the difference on its {} is the model's of one "
        "clock later, through {}",
        counted(clocks - 1, "clock"), name, counted(c.rtl_changes, "change"));
  if (c.inverted && c.model_changes >= Enough)
    return fmt::format("the RTL is inverted: in {} its {} is the model's with all bits turned",
                       seen, name);
  if (c.rtl_changes == 0 && c.model_changes >= Enough)
    return fmt::format("the RTL is stuck: in {} its {} keeps its value, the model's has {}", seen,
                       name, counted(c.model_changes, "change"));
  if (port.bits() == 1 || !c.one_bit()) return "";
  int bit = 0;
  while (c.bits >> bit != 1) ++bit;
  return fmt::format("one bit: in {} nothing but bit {} of {} differs, in {}", seen, bit, name,
                     counted(c.differing, "clock"));
}

/// How long some output differs, if all agree again and stay so.
void add_end(std::vector<std::string>& hints, const Difference& d,
             const std::vector<Sides>& outputs) {
  std::size_t last = d.before;
  for (std::size_t row = d.before; row < d.history.size(); ++row)
    for (const Sides& port : outputs)
      if (port.differ(row)) last = row;
  const std::size_t after = d.history.size() - 1 - last;
  if (after >= Difference::After / 2)
    hints.push_back(fmt::format("it passes: after {} all outputs agree again, for {} at least",
                                counted(last - d.before + 1, "clock"), counted(after, "clock")));
}

/// A reset shortly before.
void add_reset(std::vector<std::string>& hints, const Difference& d) {
  constexpr std::size_t Shortly = 16;
  for (std::size_t ago = 0; ago <= std::min(Shortly, d.before); ++ago)
    for (std::size_t n = 0; n < d.columns.size(); ++n) {
      const auto& column = d.columns[n];
      const int active = column.side == Difference::Input ? reset_value(column.port) : -1;
      if (active < 0 || d.history[d.before - ago][n] != static_cast<std::uint64_t>(active))
        continue;
      hints.push_back(ago == 0 ? fmt::format("it begins in a reset: {} is active", column.port)
                               : fmt::format("it begins {} after a reset by {}",
                                             counted(ago, "clock"), column.port));
      return;
    }
}

}  // namespace

std::string difference_table(const Difference& d) {
  const std::vector<Fold> folds = folds_of(d);
  std::vector<std::pair<std::string, Cells>> lines(1, {"clock", {}});
  for (const Fold& fold : folds) lines[0].second.push_back(clock_text(d, fold));
  const auto add = [&](const std::string& label, const auto& cell) {
    lines.emplace_back(label, Cells{});
    for (const Fold& fold : folds) lines.back().second.push_back(cell(fold.first));
  };
  for (std::size_t n = 0; n < d.columns.size(); ++n)
    if (d.columns[n].side == Difference::Input)
      add(d.columns[n].port,
          [&](std::size_t row) { return hex(d.history[row][n], d.columns[n].bits); });
  for (const Sides& port : outputs_of(d)) {
    const auto model = [&](std::size_t row) { return hex(port.model(row), port.bits()); };
    const bool agree = std::none_of(folds.begin(), folds.end(), [&](const Fold& fold) {
      return port.model(fold.first) != port.rtl(fold.first);
    });
    add(port.port() + (agree ? " both" : " model"), model);
    if (agree) continue;
    add(port.port() + " rtl", [&](std::size_t row) {
      return (port.differ(row) ? std::string(1, DifferenceMark) : "") +
             hex(port.rtl(row), port.bits());
    });
  }

  std::size_t label = 0;
  std::vector<std::size_t> widths(folds.size(), 0);
  for (const auto& [name, cells] : lines) {
    label = std::max(label, name.size());
    for (std::size_t n = 0; n < cells.size(); ++n) widths[n] = std::max(widths[n], cells[n].size());
  }
  std::string text;
  for (const auto& [name, cells] : lines) {
    text += fmt::format("  {:<{}}", name, label);
    for (std::size_t n = 0; n < cells.size(); ++n)
      text += fmt::format(" {:>{}}", cells[n], widths[n]);
    text += "\n";
  }
  return text;
}

std::string difference_hints(const Difference& d) {
  const std::vector<Sides> outputs = outputs_of(d);
  std::vector<std::string> hints;
  const std::string course = course_text(d, outputs.at(static_cast<std::size_t>(d.output)));
  if (!course.empty()) hints.push_back(course);
  if (const std::string only = difference_condition(d); !only.empty()) hints.push_back(only);
  add_end(hints, d, outputs);
  add_reset(hints, d);
  std::string text;
  for (const std::string& hint : hints) text += "hint: " + hint + "\n";
  return text;
}

std::string in_colour(const std::string& text) {
  static const TextPattern marked(fmt::format("(^|\\s)({}[0-9a-f]+)(?=\\s|$)", DifferenceMark));
  return marked.replaced(text, [](const TextPattern::Groups& found) {
    return found[1] + "\x1b[1;31m" + found[2] + "\x1b[0m";
  });
}

}  // namespace racebeam
