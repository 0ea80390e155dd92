// What the program shows of a frame beyond its picture: maps as files.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sc/chip_core.h"
#include "tb/view/interval_watcher.h"
#include "tb/view/map_picture.h"
#include "tests/program.h"

namespace racebeam {
namespace {

using nlohmann::json;
using testing::HasSubstr;

using Bytes = std::vector<std::uint8_t>;

/// Three bytes a pixel; empty if there is no such file.
Bytes read_rgb(const std::string& path) {
  const auto in = OIIO::ImageInput::open(path);
  if (!in || in->spec().nchannels != 3) return {};
  Bytes bytes(static_cast<std::size_t>(in->spec().width) * in->spec().height * 3);
  if (!in->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, bytes.data())) return {};
  return bytes;
}

/// The intervals of a frame of the demo.
std::vector<IntervalEvent> intervals_of(int frame) {
  const knobs k;
  chip_core chip;
  chip.clock(false, k);
  chip.deposit(frame, k);
  IntervalWatcher watcher;
  for (long left = 2L * LinePixels * FrameLines; left > 0; --left) {
    const int room = chip.decision_datapath.room_q, face = chip.decision_datapath.hit_face_q;
    chip_view view;
    chip.clock(true, k, &view);
    watcher.observe(view, room, face);
  }
  return watcher.take();
}

TEST(CliOverlay, MapsLieBesideTheFramesAndInTheManifest) {
  const ScratchFolder folder;
  Program program(folder.path(), {"render", "demo", "--first", "7223", "--overlay", "slack,cost",
                                  "--overlay", "depth", "-o", "o"});
  ASSERT_EQ(program.wait(), 0) << program.err();
  const json manifest = json::parse(read_file(folder / "o/manifest.json"));
  EXPECT_EQ(manifest.at("files"),
            (json{"frame_7223.png", "overlay_slack_7223.png", "overlay_cost_7223.png",
                  "overlay_depth_7223.png", "stats.json"}));
  const auto intervals = intervals_of(7223);
  for (const MapKind kind : MapKinds) {
    const RgbImage expected = map_picture(make_map(kind, intervals, Raster()), "demo frame 7223");
    const Bytes found =
        read_rgb(folder / ("o/overlay_" + std::string(map_name(kind)) + "_7223.png"));
    EXPECT_EQ(expected.height(), VisibleRows + MapBarHeight);
    EXPECT_EQ(found,
              Bytes(expected.bytes(), expected.bytes() + 3 * expected.width() * expected.height()))
        << map_name(kind);
  }
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
