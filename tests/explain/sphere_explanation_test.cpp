// A pixel of the sphere tracer explained: the states add up to its clocks, and end with its colour.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/explain/sphere_explanation.h"

#include <gmock/gmock.h>

#include "tests/support/four_pixels.h"
#include "tests/support/json.h"

namespace racebeam {
namespace {

using testing::HasSubstr;

Run four() {
  RunOptions options;
  options.scene = RACEBEAM_SOURCE_DIR "/scenes/sphere/four.toml";
  return open_run(options);
}

TEST(SphereExplanation, StatesAddUpToTheClocksOfThePixel) {
  constexpr int WithPlanes = 2;  // of the modes: three reflections, planes
  const racebeam::Run run = four();
  for (const four_pixel& p : FourPixels) {
    SCOPED_TRACE(testing::Message() << p.x << "," << p.y);
    const Json j = Json::parse(sphere_explain_json(run, {0, p.x, p.y}, ""));
    EXPECT_EQ(j.at("clocks"), p.by_mode[WithPlanes].clocks);
    EXPECT_EQ(j.at("word"), p.by_mode[WithPlanes].word);
    int clocks = 0, shadow_rays = 0, rays = 0;
    Json last;
    for (const Json& step : j.at("steps").elements()) {
      EXPECT_EQ(step.at("clock"), clocks);
      clocks += step.at("clocks").get<int>();
      rays += step.at("state") == "RAY";
      shadow_rays += step.at("state") == "LRAY";
      EXPECT_EQ(step.at("rgb").is_null(), step.at("state") != "ADD" && step.at("state") != "NEXT");
      last = step;
    }
    EXPECT_EQ(clocks, j.at("clocks"));
    EXPECT_EQ(rays, j.at("rays"));
    EXPECT_EQ(shadow_rays, j.at("shadow_rays"));
    EXPECT_EQ(last.at("state"), "NEXT");
    EXPECT_EQ(last.at("rgb"), j.at("rgb"));
  }
}

TEST(SphereExplanation, TextNamesWhatWasMet) {
  const racebeam::Run run = four();
  EXPECT_THAT(sphere_explain_text(run, {0, 200, 240}, ""), HasSubstr("\nfirst hit  sphere 0\n"));
  EXPECT_THAT(sphere_explain_text(run, {0, 396, 380}, ""), HasSubstr("\nfirst hit  light\n"));
  EXPECT_THAT(sphere_explain_text(run, {0, 396, 380}, ""), HasSubstr(", the light itself\n"));
  EXPECT_THAT(sphere_explain_text(run, {0, 20, 240}, ""), HasSubstr("\nfirst hit  plane "));
  EXPECT_EQ(sphere_size(run, 0).columns, 512);
  EXPECT_EQ(sphere_size(run, 0).rows, 480);
}

}  // namespace
}  // namespace racebeam
