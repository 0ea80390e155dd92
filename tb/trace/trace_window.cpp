// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/trace/trace_window.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <vector>

#include "tb/base/errors.h"

namespace racebeam {

namespace {

/// The numbers between colons; none if one of them is no number.
std::vector<int> numbers(const std::string& text) {
  std::vector<int> all;
  const char *at = text.data(), *const end = text.data() + text.size();
  for (;; ++at) {
    int number = 0;
    const auto [next, error] = std::from_chars(at, end, number);
    if (error != std::errc{} || (next != end && *next != ':')) return {};
    all.push_back(number);
    at = next;
    if (at == end) return all;
  }
}

}  // namespace

TracePoint point_at(std::int64_t ordinal, const Raster& raster) {
  const auto frame = ordinal / raster.frame_clocks(), rest = ordinal % raster.frame_clocks();
  return {static_cast<int>(frame),
          static_cast<int>(rest / raster.line_clocks()) + raster.first_line,
          static_cast<int>(rest % raster.line_clocks())};
}

TracePoint TraceWindowReader::point(const char* option, const std::string& text, int clock) const {
  const std::vector<int> n = numbers(text);
  if (n.size() < 2 || n.size() > 3)
    throw UsageError(
        fmt::format("{} '{}' is not of the form FRAME:LINE or FRAME:LINE:CLOCK, such as 60:-240:0",
                    option, text));
  const auto check = [&](const char* what, int value, int min, int max) {
    if (value < min || value > max)
      throw UsageError(
          fmt::format("{} {}: {} {} is out of range; {}..{}", option, text, what, value, min, max));
  };
  check("frame", n[0], 0, frames_ - 1);
  check("line", n[1], raster_.first_line, raster_.last_line());
  if (n.size() == 3) check("clock", n[2], 0, raster_.line_clocks() - 1);
  return {n[0], n[1], n.size() == 3 ? n[2] : clock};
}

void TraceWindowReader::check(const std::string& from, const std::string& to) const {
  if (!from.empty()) point("--from", from, 0);
  if (!to.empty()) point("--to", to, 0);
}

TraceWindow TraceWindowReader::window(const std::string& from, const std::string& to) const {
  const TraceWindow window{point("--from", from, 0), point("--to", to, raster_.line_clocks() - 1)};
  if (window.to.ordinal(raster_) < window.from.ordinal(raster_))
    throw UsageError(fmt::format("--to {} comes before --from {}", to, from));
  return window;
}

TraceWindow TraceWindowReader::around(const TracePoint& point, long long lines) const {
  const std::int64_t line = point.ordinal(raster_) / raster_.line_clocks();
  const std::int64_t last = static_cast<std::int64_t>(frames_) * raster_.lines - 1;
  const std::int64_t first = std::max<std::int64_t>(line - lines, 0);
  const std::int64_t end = std::min<std::int64_t>(line + lines, last) + 1;
  return {point_at(first * raster_.line_clocks(), raster_),
          point_at(end * raster_.line_clocks() - 1, raster_), point};
}

TraceWindow TraceWindowReader::around(const TracePoint& point, long long before,
                                      long long after) const {
  const std::int64_t clock = point.ordinal(raster_);
  const std::int64_t last = static_cast<std::int64_t>(frames_) * raster_.frame_clocks() - 1;
  return {point_at(std::max<std::int64_t>(clock - before, 0), raster_),
          point_at(std::min<std::int64_t>(clock + after, last), raster_), point};
}

}  // namespace racebeam
