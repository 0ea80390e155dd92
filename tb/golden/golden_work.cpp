// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/golden/golden_work.h"

namespace racebeam {

namespace {

struct CounterRow {
  counter_info info;
  std::uint64_t GoldenWork::*member;
};

std::vector<CounterRow> counter_rows(GoldenTracer tracer) {
  std::vector<CounterRow> rays = {
      {{"rays", "", 0}, &GoldenWork::rays},
      {{"decisions", "decisions", 10}, &GoldenWork::decisions},
      {{"rooms_entered", "rooms entered", 13}, &GoldenWork::rooms_entered},
      {{"crossing_decisions", "", 0}, &GoldenWork::crossing_decisions},
      {{"solid_hits", "", 0}, &GoldenWork::solid_hits},
      {{"solid_decisions", "", 0}, &GoldenWork::solid_decisions},
  };
  switch (tracer) {
    case GoldenTracer::Trace2: return rays;
    case GoldenTracer::Trace3:
      rays.push_back({{"clocks", "clocks", 10}, &GoldenWork::clocks});
      return rays;
    case GoldenTracer::Trace4:
      return {
          {{"questions", "questions", 10}, &GoldenWork::questions},
          {{"probes", "probes", 8}, &GoldenWork::probes},
          {{"intervals", "", 0}, &GoldenWork::intervals},
          {{"edges", "edges", 8}, &GoldenWork::edges},
          {{"chattering_edges", "chattering", 10}, &GoldenWork::chattering_edges},
      };
    case GoldenTracer::Geometry: break;
  }
  return {};
}

bool counts_switches(GoldenTracer tracer) { return tracer == GoldenTracer::Trace4; }
bool counts_clocks(GoldenTracer tracer) { return tracer == GoldenTracer::Trace3; }

}  // namespace

GoldenTables golden_tables(GoldenTracer tracer) {
  GoldenTables tables;
  for (const CounterRow& row : counter_rows(tracer)) tables.counters.push_back(row.info);
  if (counts_switches(tracer))
    tables.histograms.push_back({"switches", nullptr, int(SwitchCounts().size()) - 1});
  if (counts_clocks(tracer)) tables.lines.push_back({"line_clocks", "", false, "clocks of a line"});
  return tables;
}

frame_counts counted(GoldenTracer tracer, const GoldenWork& work) {
  frame_counts counts;
  for (const CounterRow& row : counter_rows(tracer)) counts.counters.push_back(work.*row.member);
  if (counts_switches(tracer))
    counts.histograms.emplace_back(work.switches.begin(), work.switches.end());
  if (counts_clocks(tracer)) counts.lines.push_back(work.line_clocks);
  return counts;
}

}  // namespace racebeam
