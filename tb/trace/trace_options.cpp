// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/trace/trace_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "tb/base/nearest.h"
#include "tb/trace/beam_trigger.h"
#include "tb/wave/draw_waveform.h"
#include "tb/wave/wave_file.h"

namespace racebeam {

namespace {

constexpr int MostFramesAround = 10, MostDepth = 9;

void check_range(const char* option, long long value, long long min, long long max) {
  if (value < min || value > max)
    throw UsageError(fmt::format("{} {} is out of range; {}..{}", option, value, min, max));
}

}  // namespace

bool TraceOptions::transactions() const { return level == LevelTlm; }
bool TraceOptions::awaits_mismatch() const { return around == Mismatch; }
bool TraceOptions::watches() const { return awaits_mismatch() || !when.empty() || record > 0; }
bool TraceOptions::searches() const { return watches() || !around.empty(); }

long long TraceOptions::lines_around() const { return lines.value_or(1); }

bool TraceOptions::needs_run() const {
  return !(from + to + output).empty() || searches() || lines || pre || post || pixels ||
         level != LevelSignal || !assignments.empty() ||
         !(units.empty() && shake.empty() && stalls.empty());
}

TraceSelection TraceOptions::selection() const {
  check_range("--depth", depth, 0, MostDepth);
  return {scopes, static_cast<int>(depth)};
}

void TraceOptions::check(const Raster& raster) const {
  check_files();
  check_level();
  check_search();
  for (const auto& [name, clocks] : {std::pair{"--pre", pre}, {"--post", post}})
    check_range(name, clocks.value_or(0), 0, MostFramesAround * raster.frame_clocks());
}

void TraceOptions::check_files() const {
  if (output.empty() && picture.empty())
    throw UsageError("-o FILE.vcd or FILE.fst, or --picture FILE.svg, says where to write");
  if (!picture.empty()) check_picture_name(picture);
  if (!output.empty()) check_waveform_name(output);
}

void TraceOptions::check_level() const {
  if (transactions() && (watches() || !picture.empty()))
    throw UsageError(
        "--when, --record, mismatches and --picture look at the wires of --level signal; leave out "
        "--level tlm, or them");
}

void TraceOptions::check_search() const {
  if (!around.empty() && !when.empty())
    throw UsageError("--around and --when are two things to look for; give one");
  if (record > 0 && !around.empty())
    throw UsageError("--record watches for mismatches by itself; leave out --around, or --record");
  std::vector<std::string> triggers = trigger_names();
  triggers.push_back(Mismatch);
  if (!around.empty() && std::find(triggers.begin(), triggers.end(), around) == triggers.end())
    throw unknown_name("trigger", around, triggers);
  if ((pre || post) && !searches())
    throw UsageError("--pre and --post are clocks around what --around, --when or --record finds");
  if (lines && !searches())
    throw UsageError("--lines are lines around what --around or --when finds");
  if (lines && (pre || post))
    throw UsageError("--lines and the clocks of --pre and --post are two windows; give one");
  if ((lines || pre) && record > 0)
    throw UsageError(
        "--record says how many lines before the event are kept; leave out --pre and --lines");
  check_range("--lines", lines_around(), 0, FrameLines - 1);
  check_range("--record", record, 0, MostFramesAround * FrameLines);
  if (pixels && (searches() || !to.empty()))
    throw UsageError("--pixels says how long the window is; leave out --to, --around and --when");
  if (!searches() && (from.empty() || (to.empty() && !pixels)))
    throw UsageError(
        "the window is missing: say --from FRAME:LINE and --to FRAME:LINE, or --around "
        "first-starved, or --when 'u_subdivider.sd_q == 4'; of an engine that does not race the "
        "beam --from PICTURE:CLOCK and --to PICTURE:CLOCK, or --from PICTURE:@X,Y and --pixels");
}

TraceWindow TraceOptions::searched(const TraceWindowReader& reader) const {
  const std::string begin = from.empty() ? reader.first() : from;
  return reader.window(begin, to.empty() ? reader.last(begin) : to);
}

TraceWindow TraceOptions::said(const TraceWindowReader& reader) const {
  if (!pixels) return reader.window(from, to);
  if (!reader.raster().of_pictures)
    throw UsageError("--pixels is for engines that do not race the beam; give --to");
  return reader.pixels(from, *pixels);
}

TraceWindow TraceOptions::around_point(const TracePoint& point, const TraceWindowReader& reader,
                                       const Raster& raster) const {
  if (record > 0) return reader.around(point, record * raster.line_clocks() - 1, post.value_or(0));
  if (pre || post) return reader.around(point, pre.value_or(0), post.value_or(0));
  return reader.around(point, lines_around());
}

long long TraceOptions::clocks_before(const Raster& raster) const {
  if (record > 0) return record * raster.line_clocks();
  const long long line = raster.line_clocks();
  return pre || post ? std::max(pre.value_or(0), line) : (lines_around() + 1) * line;
}

long long TraceOptions::most_clocks(const Raster& raster) const {
  if (record > 0) return clocks_before(raster) + post.value_or(0);
  return pre || post ? pre.value_or(0) + post.value_or(0) + 1
                     : (2 * lines_around() + 1) * raster.line_clocks();
}

UsageError TraceOptions::nothing_found(const TraceWindow& where, const TraceAxis& raster) const {
  return UsageError(fmt::format("nothing of {} from {} to {}; search further with --from and --to",
                                around.empty() ? "--when '" + when + "'" : around,
                                point_option(where.from, raster), point_option(where.to, raster)));
}

}  // namespace racebeam
