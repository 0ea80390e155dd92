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

std::string point_text(const TracePoint& at, const TraceAxis& raster) {
  if (raster.of_pictures)
    return fmt::format("picture {}, clock {}", at.frame,
                       at.ordinal(raster) % raster.frame_clocks());
  return fmt::format("frame {}, line {}, clock {}", at.frame, at.line, at.clock);
}

std::string point_option(const TracePoint& at, const TraceAxis& raster) {
  if (raster.of_pictures)
    return fmt::format("{}:{}", at.frame, at.ordinal(raster) % raster.frame_clocks());
  return fmt::format("{}:{}", at.frame, at.line);
}

TracePoint point_at(std::int64_t ordinal, const Raster& raster) {
  const auto frame = ordinal / raster.frame_clocks(), rest = ordinal % raster.frame_clocks();
  return {static_cast<int>(frame),
          static_cast<int>(rest / raster.line_clocks()) + raster.first_line,
          static_cast<int>(rest % raster.line_clocks())};
}

TracePoint TraceWindowReader::in_picture(int picture, std::int64_t clock) const {
  return point_at(static_cast<std::int64_t>(picture) * raster_.frame_clocks() + clock, raster_);
}

const PixelClocks& TraceWindowReader::clocks_of(int picture) const {
  const auto known = known_.find(picture);
  return known != known_.end() ? known->second
                               : known_.emplace(picture, pixels_(picture)).first->second;
}

TracePoint TraceWindowReader::picture_point(const char* option, const std::string& text,
                                            bool ends) const {
  const auto colon = text.find(':');
  const bool pixel = colon != std::string::npos && text.compare(colon, 2, ":@") == 0;
  std::string plain = text;
  if (pixel) {
    plain.erase(colon + 1, 1);
    std::replace(plain.begin(), plain.end(), ',', ':');
  }
  const std::vector<int> n = numbers(plain);
  if (n.size() != (pixel ? 3 : 2))
    throw UsageError(
        fmt::format("{} '{}' is not of the form PICTURE:CLOCK or PICTURE:@X,Y, such as 0:250000 or "
                    "0:@200,240",
                    option, text));
  const auto check = [&](const char* what, int value, int max) {
    if (value < 0 || value > max)
      throw UsageError(
          fmt::format("{} {}: {} {} is out of range; 0..{}", option, text, what, value, max));
  };
  check("picture", n[0], frames_ - 1);
  if (!pixel) {
    check("clock", n[1], raster_.frame_clocks() - 1);
    return in_picture(n[0], n[1]);
  }
  const PixelClocks& clocks = clocks_of(n[0]);
  check("column", n[1], clocks.columns - 1);
  check("row", n[2], clocks.rows - 1);
  const std::size_t number = clocks.number(n[1], n[2]);
  return in_picture(n[0], ends ? clocks.begins[number + 1] - 1 : clocks.begins[number]);
}

TraceWindow TraceWindowReader::pixels(const std::string& from, long long number) const {
  if (from.find(":@") == std::string::npos)
    throw UsageError("--pixels counts from a pixel: write --from PICTURE:@X,Y");
  const TracePoint begin = point("--from", from, 0);
  const PixelClocks& clocks = clocks_of(begin.frame);
  const std::int64_t clock = begin.ordinal(raster_) % raster_.frame_clocks();
  const auto first = std::lower_bound(clocks.begins.begin(), clocks.begins.end(), clock);
  if (number < 1 || number > clocks.begins.end() - first - 1)
    throw UsageError(
        fmt::format("--pixels {} is out of range; 1..{}", number, clocks.begins.end() - first - 1));
  return {begin, in_picture(begin.frame, first[number] - 1)};
}

std::string TraceWindowReader::first() const {
  return raster_.of_pictures ? "0:0" : fmt::format("0:{}", raster_.first_line);
}

std::string TraceWindowReader::last(const std::string& from) const {
  if (!raster_.of_pictures)
    return from.substr(0, from.find(':')) + fmt::format(":{}", raster_.last_line());
  const int picture = point("--from", from, 0).frame;
  return fmt::format("{}:{}", picture, clocks_of(picture).begins.back() - 1);
}

TracePoint TraceWindowReader::point(const char* option, const std::string& text, int clock) const {
  if (raster_.of_pictures) return picture_point(option, text, clock > 0);
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
  if (!to.empty()) point("--to", to, raster_.line_clocks() - 1);
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
