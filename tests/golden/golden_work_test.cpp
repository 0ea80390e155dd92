// What the golden tracers count: rays one by one, intervals, and how often an edge switches.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/golden/golden_work.h"

#include <gtest/gtest.h>

#include <numeric>
#include <string>

#include "tb/golden/tracer_2.h"
#include "tb/golden/tracer_3.h"
#include "tb/golden/tracer_4.h"
#include "tb/scene/scene_reader.h"
#include "tb/show/demo_parts.h"
#include "tb/show/show.h"
#include "tests/golden/golden_hits.h"

namespace racebeam {
namespace {

constexpr int Every = 7;  // lines

/// A frame of each part of the demo that is traced.
std::vector<int> demo_frames() {
  std::vector<int> frames;
  for (const DemoPart& part : demo_parts())
    if (GoldenWorld(part.first_frame, {}).lock == GoldenLock::None)
      frames.push_back(part.first_frame + (part.last_frame - part.first_frame) * 2 / 3);
  return frames;
}

Show spiral() { return {read_scene_file(RACEBEAM_SOURCE_DIR "/scenes/spiral.toml").scene, ""}; }

void expect_trace_3_is_trace_2(const GoldenWorld& world, const GoldenCamera& camera) {
  RayWork two, three;
  for (int y = FirstVisibleLine; y < FirstVisibleLine + VisibleRows; y += Every) {
    const GoldenRays rays = camera.rays(y);
    const GoldenHits a = trace_2_line(world, rays, y, &two);
    const GoldenHits b = trace_3_line(world, rays, y, &three);
    for (int p = 0; p < VisibleColumns; ++p)
      ASSERT_TRUE(same_hit(a[p], b[p])) << "line " << y << " pixel " << p;
  }
  EXPECT_GT(three.decisions, three.rays);
  EXPECT_EQ(three.rays, two.rays);
  EXPECT_EQ(three.decisions, two.decisions);
  EXPECT_EQ(three.rooms_entered, two.rooms_entered);
  EXPECT_EQ(three.crossing_decisions, two.crossing_decisions);
  EXPECT_EQ(three.solid_hits, two.solid_hits);
  EXPECT_EQ(three.solid_decisions, two.solid_decisions);
  EXPECT_EQ(three.clocks, three.decisions + three.rooms_entered + 2 * three.rays)
      << "signs and colour of each ray";
  EXPECT_EQ(two.clocks, 0u);
}

TEST(Trace3, ShowsWhatTrace2ShowsDecisionForDecision) {
  for (const int frame : demo_frames()) {
    SCOPED_TRACE(frame);
    expect_trace_3_is_trace_2(GoldenWorld(frame, {}), GoldenCamera(frame));
  }
  const Show show = spiral();
  for (const int frame : {0, show.frames() / 3})
    expect_trace_3_is_trace_2(show.golden_world(frame, show.standard_knobs()),
                              show.golden_camera(frame, knobs{}));
}

TEST(Trace2, TakesSixDecisionsThroughARoomAndTwoAtASolidWall) {
  RayWork all;
  for (const int frame : demo_frames()) {
    RayWork work;
    for (int y = FirstVisibleLine; y < FirstVisibleLine + VisibleRows; y += Every)
      trace_2_line(GoldenWorld(frame, {}), GoldenCamera(frame).rays(y), y, &work);
    EXPECT_EQ(work.crossing_decisions, 6 * work.rooms_entered) << frame;
    EXPECT_EQ(work.solid_decisions, 2 * work.solid_hits) << frame;
    // The rest ends beside an opening: after three to six.
    const auto beside = work.rays - work.solid_hits;
    const auto decisions = work.decisions - work.crossing_decisions - work.solid_decisions;
    EXPECT_GE(decisions, 3 * beside) << frame;
    EXPECT_LE(decisions, 6 * beside) << frame;
    all.rooms_entered += work.rooms_entered;
    all.solid_hits += work.solid_hits;
  }
  EXPECT_GT(all.rooms_entered, 0u);
  EXPECT_GT(all.solid_hits, 0u);
}

TEST(Trace2, TakesMoreWhereAFaceHasMoreOpenings) {
  const Show show = spiral();
  const GoldenWorld world = show.golden_world(show.frames() / 3, show.standard_knobs());
  RayWork work;
  for (int y = FirstVisibleLine; y < FirstVisibleLine + VisibleRows; y += Every)
    trace_2_line(world, show.golden_camera(show.frames() / 3, knobs{}).rays(y), y, &work);
  EXPECT_GT(work.crossing_decisions, 6 * work.rooms_entered);
}

/// Rays with all fraction bits: 512 times as long, and exactly linear.
GoldenRays exact_rays(const GoldenCamera& camera, int y) {
  const GoldenLine line = golden_line(camera.view(y), y);
  GoldenRays rays;
  for (int p = 0; p < VisibleColumns; ++p)
    for (int a = 0; a < 3; ++a) rays[p][a] = 512 * line.dr_0[a] + p * line.ddr[a];
  return rays;
}

template <class Rays>
IntervalWork work_of(const std::vector<int>& frames, const Rays& rays) {
  IntervalWork work;
  for (const int frame : frames) {
    const GoldenWorld world(frame, {});
    for (int y = FirstVisibleLine; y < FirstVisibleLine + VisibleRows; y += Every)
      trace_4_line(world, rays(GoldenCamera(frame), y), y, &work);
  }
  return work;
}

TEST(Switches, AnEdgeSwitchesOnceAtMostAlongExactRays) {
  const IntervalWork work = work_of(demo_frames(), exact_rays);
  EXPECT_GT(work.edges, 10'000u);
  EXPECT_EQ(work.chattering_edges, 0u);
  EXPECT_EQ(work.switches[0] + work.switches[1],
            std::accumulate(work.switches.begin(), work.switches.end(), std::uint64_t{0}));
}

// Measured: 1.85 % of the edges of these lines, up to 3.7 % in a frame.
TEST(Switches, RoundedRaysChatterAtSomeEdges) {
  const IntervalWork work =
      work_of(demo_frames(), [](const GoldenCamera& camera, int y) { return camera.rays(y); });
  EXPECT_GT(work.chattering_edges, work.edges / 100);
  EXPECT_LT(work.chattering_edges, work.edges / 25);
  std::uint64_t questions = 0, edges = 0, chattering = 0;
  for (std::size_t n = 0; n < work.switches.size(); ++n) {
    questions += work.switches[n];
    edges += n > 0 ? work.switches[n] : 0;
    chattering += n > 1 ? work.switches[n] : 0;
  }
  EXPECT_EQ(edges, work.edges);
  EXPECT_EQ(chattering, work.chattering_edges);
  const std::uint64_t lines = demo_frames().size() * ((VisibleRows + Every - 1) / Every);
  EXPECT_EQ(questions, work.questions - (work.intervals - lines))
      << "what is asked anew after a return counts once";
}

TEST(GoldenWork, OfAPictureIsThatOfItsLines) {
  const int frame = 5000;
  const GoldenWorld world(frame, {});
  const GoldenCamera camera(frame);
  GoldenWork work;
  const GoldenPicture counted_picture = golden_picture(GoldenTracer::Trace3, world, camera, &work);
  EXPECT_EQ(counted_picture, golden_picture(GoldenTracer::Trace2, world, camera));
  ASSERT_EQ(work.line_clocks.size(), 480u);
  EXPECT_EQ(std::accumulate(work.line_clocks.begin(), work.line_clocks.end(), std::uint64_t{0}),
            work.clocks);
  const frame_counts counts = counted(GoldenTracer::Trace3, work);
  const GoldenTables tables = golden_tables(GoldenTracer::Trace3);
  ASSERT_EQ(counts.counters.size(), tables.counters.size());
  for (std::size_t n = 0; n < counts.counters.size(); ++n)
    if (std::string(tables.counters[n].name) == "clocks") {
      EXPECT_EQ(counts.counters[n], work.clocks);
    }
  EXPECT_EQ(counts.lines, std::vector<std::vector<int>>{work.line_clocks});
}

TEST(GoldenWork, TablesFitWhatIsCounted) {
  for (const auto tracer :
       {GoldenTracer::Trace2, GoldenTracer::Trace3, GoldenTracer::Trace4, GoldenTracer::Geometry}) {
    const GoldenTables tables = golden_tables(tracer);
    const frame_counts counts = counted(tracer, {});
    EXPECT_EQ(counts.counters.size(), tables.counters.size());
    EXPECT_EQ(counts.histograms.size(), tables.histograms.size());
    EXPECT_EQ(counts.lines.size(), tables.lines.size());
    for (std::size_t n = 0; n < counts.histograms.size(); ++n)
      EXPECT_EQ(static_cast<int>(counts.histograms[n].size()), tables.histograms[n].limit + 1);
  }
  EXPECT_TRUE(golden_tables(GoldenTracer::Geometry).counters.empty());
}

// The seed: 21 to 38 times the decisions of intervals.
TEST(GoldenWork, IntervalsSaveMostDecisionsOfRaysOneByOne) {
  const int frame = 5000;
  GoldenWork rays, intervals;
  golden_picture(GoldenTracer::Trace3, GoldenWorld(frame, {}), GoldenCamera(frame), &rays);
  golden_picture(GoldenTracer::Trace4, GoldenWorld(frame, {}), GoldenCamera(frame), &intervals);
  const std::uint64_t asked = 2 * intervals.questions + intervals.probes;
  EXPECT_GT(rays.decisions, 15 * asked);
  EXPECT_LT(rays.decisions, 60 * asked);
}

}  // namespace
}  // namespace racebeam
