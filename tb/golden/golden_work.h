// What the golden tracers do for a picture, counted: the price of rays and of intervals.
//
// The tables say what each tracer counts, in the manner of an engine's.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sc/base/frame_counts.h"
#include "tb/golden/golden_picture.h"

namespace racebeam {

/// Of rays traced one by one. A decision says on which side of an edge a ray passes.
struct RayWork {
  std::uint64_t rays = 0;
  std::uint64_t decisions = 0;
  std::uint64_t rooms_entered = 0;
  std::uint64_t crossing_decisions = 0;  ///< in rooms that the ray leaves by an opening
  std::uint64_t solid_hits = 0;          ///< rays that end at a face without an opening, or at the
                                         ///< depth limit
  std::uint64_t solid_decisions = 0;     ///< in the rooms where they do
  std::uint64_t clocks = 0;              ///< of trace_3
};

/// By how often the answer to a question changes from pixel to pixel along an interval; the last:
/// or more often.
using SwitchCounts = std::array<std::uint64_t, 17>;

/// Of a line traced by intervals.
struct IntervalWork {
  std::uint64_t questions = 0;         ///< asked at both ends of an interval
  std::uint64_t probes = 0;            ///< asked at one pixel between, to bisect
  std::uint64_t intervals = 0;         ///< emitted
  std::uint64_t edges = 0;             ///< questions whose answer changes within the interval
  std::uint64_t chattering_edges = 0;  ///< more than once
  SwitchCounts switches{};             ///< questions
};

struct GoldenWork : RayWork, IntervalWork {
  std::vector<int> line_clocks;  ///< of trace_3, by visible line
};

/// What a tracer counts.
struct GoldenTables {
  std::vector<counter_info> counters;
  std::vector<histogram_info> histograms;
  std::vector<line_info> lines;
};
GoldenTables golden_tables(GoldenTracer tracer);

/// By the tables.
frame_counts counted(GoldenTracer tracer, const GoldenWork& work);

}  // namespace racebeam
