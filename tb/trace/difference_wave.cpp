// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/trace/difference_wave.h"

#include <filesystem>

#include "sc/base/constants.h"
#include "tb/scene/engines.h"
#include "tb/trace/chip_signals.h"
#include "tb/trace/signal_trace.h"
#include "tb/trace/trace_files.h"
#include "tb/twin/lockstep_report.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

/// A row of the history, as signals of the chip.
class DifferenceRow {
 public:
  explicit DifferenceRow(const LockstepDifference& d) : d_(d) {}

  void go_to(std::size_t row) { row_ = &d_.history.at(row); }
  std::uint64_t value(std::size_t column) const {
    return raw_bits((*row_)[column], d_.columns[column].bits);
  }
  bool differs() const {
    for (std::size_t n = 1; n < d_.columns.size(); ++n)
      if (d_.columns[n].side == LockstepDifference::Rtl && value(n) != value(n - 1)) return true;
    return false;
  }
  /// They can be read as long as this lives.
  std::vector<ChipSignal> signals() const {
    const std::string scope = scope_of_unit(d_.unit);
    std::vector<ChipSignal> all = {{"chip", "clk_i", 1}};
    if (scope != "chip") all.push_back({scope, "clk_i", 1});
    for (std::size_t n = 0; n < d_.columns.size(); ++n)
      all.push_back({scope + (d_.columns[n].side == LockstepDifference::Rtl ? ".rtl" : ""),
                     d_.columns[n].port,
                     d_.columns[n].bits,
                     {},
                     [this, n] { return value(n); }});
    all.push_back({scope + ".rtl", "differs", 1, {}, [this] { return std::uint64_t{differs()}; }});
    return all;
  }

 private:
  const LockstepDifference& d_;
  const std::vector<std::uint64_t>* row_ = nullptr;
};

/// The rows that lie side by side in time with that of the difference.
struct Stretch {
  std::size_t first, last;
};

std::string path_of(const LockstepDifference& d, const std::string& traffic,
                    const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw OutputError(folder, error.message());
  return (fs::path(folder) / (d.unit + "_" + traffic + ".vcd")).string();
}

std::string comment_of(const LockstepDifference& d) {
  return "racebeam: the clocks around the first difference of " + d.unit;
}

void commit(TraceFiles& files, const LockstepDifference& d, std::uint64_t period,
            std::uint64_t first, std::uint64_t end, std::uint64_t difference) {
  files.commit({first * period, end * period, period, difference * period,
                DifferingPort{scope_of_unit(d.unit), d.port}});
}

/// Of a clock, in picoseconds.
int period_of(const knob_values& k) {
  return clock_period_ps(engine_of(k).video(k).clocks_per_pixel);
}

}  // namespace

std::string save_chip_window(const LockstepDifference& d, const DrivenFrames& frames,
                             const knob_values& k, const std::string& folder) {
  const TraceAxis axis(frames.raster, frames.show.engine().races_beam);
  const auto point = [&](std::size_t row) {
    const BeamPlace place = place_of(d.first_clock() + row, frames.numbers, frames.raster);
    return TracePoint{place.frame, place.line, place.clock};
  };
  const auto follows = [&](std::size_t row) {  // on the row before it; none does on the reset
    return d.first_clock() + row > 1 &&
           point(row).ordinal(axis) == point(row - 1).ordinal(axis) + 1;
  };
  Stretch shown{d.before, d.before};
  while (shown.first > 0 && follows(shown.first)) --shown.first;
  while (shown.last + 1 < d.history.size() && follows(shown.last + 1)) ++shown.last;

  const std::string path = path_of(d, "chip", folder);
  const int period = period_of(k);
  DifferenceRow row(d);
  VcdWriter vcd;
  SignalTrace trace(
      row.signals(), axis, period, {}, false, [&](int frame) { return frames.show.part(frame); },
      vcd);
  TraceFiles files(path, "", comment_of(d), vcd);
  for (std::size_t n = shown.first; n <= shown.last; ++n) {
    row.go_to(n);
    trace.sample(point(n));
  }
  const auto ordinal = [&](std::size_t n) {
    return static_cast<std::uint64_t>(point(n).ordinal(axis));
  };
  commit(files, d, static_cast<std::uint64_t>(period), ordinal(shown.first),
         ordinal(shown.last) + 1, ordinal(d.before));
  return path;
}

std::string save_unit_window(const LockstepDifference& d, const std::string& traffic,
                             const knob_values& k, const std::string& folder) {
  const std::string path = path_of(d, traffic, folder);
  const auto period = static_cast<std::uint64_t>(period_of(k));
  DifferenceRow row(d);
  VcdWriter vcd;
  const int clk = vcd.add("chip", "clk_i", 1), count = vcd.add("chip", "clock", 64);
  const std::vector<ChipSignal> signals = row.signals();
  std::vector<int> numbers;  // by signal; the clocks' is `clk`
  for (const ChipSignal& one : signals) {
    numbers.push_back(one.is_clock() ? clk : vcd.add(one.scope, one.name, one.bits));
    if (one.is_clock() && one.scope != "chip") vcd.alias(one.scope, one.name, clk);
  }
  TraceFiles files(path, "", comment_of(d), vcd);
  for (std::size_t n = 0; n < d.history.size(); ++n) {
    const std::uint64_t clock = d.first_clock() + n, at = clock * period;
    row.go_to(n);
    vcd.change(at, clk, 1);
    vcd.change(at, count, clock);
    for (std::size_t s = 0; s < signals.size(); ++s)
      if (!signals[s].is_clock()) vcd.change(at, numbers[s], signals[s].read());
    vcd.change(at + period / 2, clk, 0);
  }
  commit(files, d, period, d.first_clock(), d.first_clock() + d.history.size(), d.clock);
  return path;
}

}  // namespace racebeam
