// The figures of a sweep are those of the chip, whatever has simulated it: its cores in a loop or
// units with wires, this build or another one.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "sc/beam/engine.h"
#include "tb/bench/signal_bench.h"
#include "tb/judge/reference_picture.h"
#include "tb/judge/visible_error.h"
#include "tb/show/open_show.h"
#include "tb/sweep/columns.h"
#include "tb/sweep/row_digest.h"
#include "tests/cli/sweep_bench.h"

namespace racebeam {
namespace {

using CliSweepLevels = CliSweepTest;

TEST_F(CliSweepLevels, DigestsAreThoseOfTheChipOfSignals) {
  write("[frames]\nsample = 3\nguard = 0\n[base]\nknobs = { hurry_threshold = 64 }\n");
  expect_run("out");
  const Show show = open_show("demo");
  SignalBench::Options options;
  options.k = show.standard_knobs();
  options.k.hurry_threshold = 64;
  options.stats = true;
  SignalBench bench(options);
  const ReferencePicture reference(show, PictureReference::Geometry, options.k, options.k);
  const auto rows = read_csv(frames_of("out"));
  ASSERT_EQ(rows.size(), 3u);
  std::vector<std::string> digests;
  for (const auto& row : rows) {
    const int frame = std::stoi(row.at("frame"));
    bench.seek(frame);
    const ChipBench::Frame rendered = bench.render();
    const GoldenPicture& colours = rendered.picture.colours;
    const GoldenPicture right = reference.picture(frame);
    const std::vector<std::int64_t> errors{golden_difference(colours, right),
                                           visible_difference(colours, right)};
    const auto values = column_values(show.engine(), *rendered.stats, errors, colours);
    EXPECT_EQ(row.at("digest"), fmt::format("{:016x}", frame_digest(frame, values))) << frame;
    digests.push_back(row.at("digest"));
  }
  // Of a build with -O3; sanitizers have the same. A new column changes them.
  EXPECT_THAT(digests,
              testing::ElementsAre("1e9bd46c60c43c1b", "eda8f458baa360de", "75a76cfd3dbd81b5"));
}

// demo_frames.csv is of a build with -O3; sanitizers count the same.
TEST_F(CliSweepLevels, EveryBuildCountsTheSame) {
  write(
      "[frames]\nsample = 24\nguard = 0\n[knobs]\nhurry_threshold = 64\n"
      "[search]\nrace = false\nseed = 2\n");
  expect_run("out");
  std::map<std::string, std::map<std::string, std::string>> pinned;
  for (const auto& row : read_csv(read_file(RACEBEAM_SOURCE_DIR "/tests/sweep/demo_frames.csv")))
    pinned[row.at("frame")] = row;
  int compared = 0;
  for (const auto& row : read_csv(frames_of("out"))) {
    const auto at = pinned.find(row.at("frame"));
    if (at == pinned.end()) continue;
    ++compared;
    const std::string which = row.at("point") == "chip" ? "" : "_64";
    if (which.empty()) {
      EXPECT_EQ(row.at("decisions"), at->second.at("decisions"));
    }
    EXPECT_EQ(row.at("busy_clocks.sum"), at->second.at("busy_clocks" + which));
    EXPECT_EQ(row.at("starved_pixels"), at->second.at("starved_pixels" + which));
  }
  EXPECT_GT(compared, 20);
}

}  // namespace
}  // namespace racebeam
