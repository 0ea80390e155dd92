// How far the golden tracers agree on scene files, the shipped ones and one with many portals.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/golden/golden_hits.h"
#include "tests/golden/golden_scene_bench.h"

namespace racebeam {
namespace {

using Tracer = GoldenTracer;

constexpr double Pixels = VisibleColumns * VisibleRows;

// Four and two openings in a face, every height and width another; the camera turns by odd angles.
std::string hub() {
  return "frames = 600\n[camera]\nroom = \"hub\"\nposition = [40, 20, -30]\nfov = 112\n"
         "yaw = { start = 3, step = 7 }\npitch = { start = -40, step = 1, every = 3 }\n" +
         room("hub", "0, 0, 0", "400, 160, 300",
              "north = [\"n0\", \"n1\", \"n2\", \"n3\"], east = [\"e0\", \"e1\"], "
              "south = [\"s0\", \"s1\", \"s2\"], up = [\"u0\", \"u1\"], west = \"w0\"") +
         room("n0", "-300, 20, 400", "60, 100, 100", "up = [\"n0a\", \"n0b\"]") +
         room("n0a", "-320, -140, 360", "30, 60, 40") +
         room("n0b", "-270, -130, 450", "20, 50, 40") +
         room("n1", "-100, -40, 600", "70, 90, 300") + room("n2", "90, 60, 350", "50, 50, 50") +
         room("n3", "280, 0, 500", "90, 150, 200", "east = [\"n3a\", \"n3b\"]") +
         room("n3a", "470, 20, 400", "100, 60, 60") + room("n3b", "470, 20, 600", "100, 60, 60") +
         room("e0", "500, 0, -150", "100, 120, 100") + room("e1", "450, 40, 100", "50, 80, 70") +
         room("s0", "-200, 0, -400", "90, 60, 100") + room("s1", "0, 0, -500", "60, 120, 200") +
         room("s2", "200, 30, -350", "100, 100, 50") + room("u0", "-150, -200, 0", "90, 40, 200") +
         room("u1", "150, -260, 50", "100, 100, 100") + room("w0", "-500, 0, 0", "100, 100, 150");
}

SceneFile shipped(const std::string& name) {
  SceneResult result = read_scene_file(RACEBEAM_SOURCE_DIR "/scenes/" + name);
  EXPECT_EQ(result.faults.text(name), "");
  return std::move(result.scene);
}

/// Shares of a frame: mean over some frames, and largest.
struct Shares {
  double sum = 0, largest = 0;
  int frames = 0;

  void add(int pixels) {
    sum += pixels / Pixels;
    largest = std::max(largest, pixels / Pixels);
    ++frames;
  }
  double mean() const { return sum / frames; }
};

Shares hits_of_trace_4_that_differ(const GoldenScene& shown, int every) {
  Shares shares;
  for (int frame = 0; frame < shown.scene.frames; frame += every) {
    const GoldenWorld world = shown.world(frame);
    const GoldenCamera camera = shown.camera(frame);
    int pixels = 0;
    for (int y = -240; y < 240; ++y) {
      const GoldenRays rays = camera.rays(y);
      const GoldenHits by_pixel = trace_2_line(world, rays, y);
      const GoldenHits by_interval = trace_4_line(world, rays, y);
      for (int p = 0; p < VisibleColumns; ++p) pixels += !same_hit(by_pixel[p], by_interval[p]);
    }
    shares.add(pixels);
  }
  return shares;
}

Shares colours_of_geometry_that_differ(const GoldenScene& shown, int every) {
  Shares shares;
  for (int frame = 0; frame < shown.scene.frames; frame += every)
    shares.add(golden_difference(shown.picture(Tracer::Trace2, frame),
                                 shown.picture(Tracer::Geometry, frame)));
  return shares;
}

// Measured over every seventh frame: 0.0014, 0.0016 and 0.0078 % of the pixels, at most 0.06 %.
TEST(SceneTracers, Trace4DiffersFromTrace2OnlyWhereAnEdgeChatters) {
  for (const GoldenScene& shown : {GoldenScene(shipped("house.toml")),
                                   GoldenScene(shipped("maze.toml")), GoldenScene(hub())}) {
    const Shares shares = hits_of_trace_4_that_differ(shown, 47);
    EXPECT_GT(shares.largest, 0) << shown.scene.name;
    EXPECT_LT(shares.largest, 0.001) << shown.scene.name;
    EXPECT_LT(shares.mean(), 0.0002) << shown.scene.name;
  }
}

// Measured over every seventh frame: house 0.62 % of the pixels, at most 1.8 %; maze 0.63 %, 1.8 %.
TEST(SceneTracers, GeometryDiffersFromTrace2ByTheCamerasRounding) {
  for (const char* name : {"house.toml", "maze.toml"}) {
    const Shares shares = colours_of_geometry_that_differ(GoldenScene(shipped(name)), 97);
    EXPECT_LT(shares.largest, 0.025) << name;
    EXPECT_LT(shares.mean(), 0.01) << name;
  }
}

// Its focal length is short and its walls are near: 1.9 %, at most 3.5 %.
TEST(SceneTracers, GeometryDiffersBySomewhatMoreWhereTheViewIsWide) {
  const Shares shares = colours_of_geometry_that_differ(GoldenScene(hub()), 47);
  EXPECT_LT(shares.largest, 0.045);
  EXPECT_LT(shares.mean(), 0.025);
}

// Boxes asked by ang_leq and by points: on the same rays they agree.
TEST(SceneTracers, Trace2HitsTheWallThatGeometryHitsWithTheSameRay) {
  for (const GoldenScene& shown : {GoldenScene(shipped("house.toml")), GoldenScene(hub())})
    for (int frame = 5; frame < shown.scene.frames; frame += shown.scene.frames / 8)
      expect_trace_2_agrees_with_geometry(shown.world(frame), shown.camera(frame), 5);
}

}  // namespace
}  // namespace racebeam
