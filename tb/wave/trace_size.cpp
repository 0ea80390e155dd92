// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/wave/trace_size.h"

#include <fmt/format.h>

#include <cmath>

#include "tb/base/counted.h"
#include "tb/wave/wave_file.h"

namespace racebeam {

namespace {

// Of a clock, on average over frames of the demo and of scene files.
constexpr double BytesOfBeam = 58, BytesOfSignal = 0.55;
constexpr double BytesOfCalmBeam = 34, BytesOfCalmSignal = 0.28;
constexpr double BytesOfTransactions = 1.4;
constexpr double SecondsOfChip = 0.44e-6, SecondsOfSignal = 5e-9, SecondsOfTransactions = 40e-9;

constexpr double FstRatio = 20, FstBytesASecond = 60e6;
constexpr double LongBytes = 100e6, LongSeconds = 10;

std::string time_text(double seconds) {
  if (seconds < 90) return counted(static_cast<long long>(std::ceil(seconds)), "second");
  if (seconds < 5400) return counted(std::llround(seconds / 60), "minute");
  return counted(std::llround(seconds / 3600), "hour");
}

}  // namespace

TraceSize TraceSize::of_transactions(std::int64_t clocks) {
  const auto count = static_cast<double>(clocks);
  return {count * BytesOfTransactions, count * SecondsOfTransactions};
}

TraceSize TraceSize::of_signals(std::int64_t clocks, std::int64_t before, std::size_t signals,
                                bool overview) {
  const auto count = static_cast<double>(clocks), all = static_cast<double>(signals);
  return {count * (overview ? BytesOfCalmBeam + all * BytesOfCalmSignal
                            : BytesOfBeam + all * BytesOfSignal),
          (count + static_cast<double>(before)) * SecondsOfChip + count * all * SecondsOfSignal};
}

bool TraceSize::is_long() const { return bytes >= LongBytes || seconds >= LongSeconds; }

std::string TraceSize::room_text(const std::string& output, double free) const {
  const double needed = is_fst(output) ? bytes * (1 + 1 / FstRatio) : bytes;
  return free >= needed ? ""
                        : fmt::format("it will not fit: {} are free there, and it takes {}",
                                      bytes_text(free), bytes_text(needed));
}

std::string TraceSize::text(const std::string& output) const {
  if (!is_fst(output))
    return fmt::format("about {} and {}; as FST about {}", bytes_text(bytes), time_text(seconds),
                       bytes_text(bytes / FstRatio));
  return fmt::format("about {} and {}, made of {} of VCD", bytes_text(bytes / FstRatio),
                     time_text(seconds + bytes / FstBytesASecond), bytes_text(bytes));
}

std::string bytes_text(double bytes) {
  const char* const units[] = {"KB", "MB", "GB", "TB"};
  double count = bytes / 1e3;
  int unit = 0;
  while (count >= 999.5 && unit < 3) {
    count /= 1e3;
    ++unit;
  }
  return fmt::format(count < 9.95 ? "{:.1f} {}" : "{:.0f} {}", count, units[unit]);
}

}  // namespace racebeam
