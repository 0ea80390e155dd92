// Maps of a frame as files: render --overlay.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/program.h"
#include "tests/cli/view_pictures.h"

namespace racebeam {
namespace {

using testing::HasSubstr;

TEST(CliOverlay, MapsLieBesideTheFramesAndInTheManifest) {
  const ScratchFolder folder;
  Program program(folder.path(), {"render", "demo", "--first", "7223", "--overlay", "slack,cost",
                                  "--overlay", "depth", "-o", "o"});
  ASSERT_EQ(program.wait(), 0) << program.err();
  const Json manifest = read_json(folder / "o/manifest.json");
  EXPECT_EQ(manifest.at("files"),
            (Json{"frame_7223.png", "overlay_slack_7223.png", "overlay_cost_7223.png",
                  "overlay_depth_7223.png", "stats.json"}));
  for (const MapKind kind : MapKinds)
    EXPECT_EQ(read_rgb(folder / ("o/overlay_" + std::string(map_name(kind)) + "_7223.png")),
              map_of(kind, 7223))
        << map_name(kind);
}

TEST(CliOverlay, GetsAFolderEvenIfOtherFilesAreAskedFor) {
  const ScratchFolder folder;
  Program program(folder.path(), {"render", "demo", "--overlay", "depth", "--stats", "a.json"});
  ASSERT_EQ(program.wait(), 0) << program.err();
  EXPECT_FALSE(read_rgb(folder / "racebeam_out/overlay_depth_0000.png").empty());
}

TEST(CliOverlay, UnknownMapNamesTheNearestOne) {
  const ScratchFolder folder;
  Program program(folder.path(), {"render", "demo", "--overlay", "slak"});
  EXPECT_EQ(program.wait(), 2);
  EXPECT_THAT(program.err(), HasSubstr("slack"));
  EXPECT_EQ(folder.files(), 0);
}

TEST(CliOverlay, AGoldenTracerHasNone) {
  const ScratchFolder folder;
  Program program(folder.path(), {"render", "demo", "--overlay", "cost", "--golden", "trace2"});
  EXPECT_EQ(program.wait(), 2);
  EXPECT_THAT(program.err(), HasSubstr("leave out --golden"));
}

}  // namespace
}  // namespace racebeam
