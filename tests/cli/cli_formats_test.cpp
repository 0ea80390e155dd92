// Pictures in formats by name: render --format, and -o with a picture's name.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "tests/cli/program.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using Words = std::vector<std::string>;

class CliFormatsTest : public testing::Test {
 protected:
  std::string render(const Words& more, int code = 0) {
    Words words = {"render", "demo", "--first", "7223"};
    words.insert(words.end(), more.begin(), more.end());
    Program run(folder.path(), words);
    EXPECT_EQ(run.wait(), code) << run.err();
    return run.err();
  }

  ScratchFolder folder;
};

TEST_F(CliFormatsTest, AFolderIsOfOneFormatWhoeverRenders) {
  const Words three = {"--frames", "3", "--overlay", "slack", "--format", "tiff"};
  Words alone = three, many = three;
  alone.insert(alone.end(), {"-o", "a"});
  many.insert(many.end(), {"-o", "b", "--jobs", "2"});
  render(alone);
  render(many);
  const Json manifest = read_json(folder / "a/manifest.json");
  ASSERT_EQ(manifest.at("files"),
            (Json{"frame_7223.tiff", "overlay_slack_7223.tiff", "frame_7224.tiff",
                  "overlay_slack_7224.tiff", "frame_7225.tiff", "overlay_slack_7225.tiff",
                  "stats.json"}));
  for (const Json& name : manifest.at("files").elements()) {
    const auto file = name.get<std::string>();
    if (file == "stats.json") continue;
    EXPECT_EQ(read_file(folder / ("a/" + file)), read_file(folder / ("b/" + file))) << file;
  }
}

TEST_F(CliFormatsTest, OverwriteTakesAwayFramesOfAnyFormat) {
  render({"-o", "o", "--format", "exr"});
  render({"-o", "o", "--set", "dr_bits=9", "--overwrite"});
  EXPECT_FALSE(std::filesystem::exists(folder / "o/frame_7223.exr"));
  EXPECT_TRUE(std::filesystem::exists(folder / "o/frame_7223.png"));
}

TEST_F(CliFormatsTest, OnePictureLiesAloneAndGoldenTracersDrawItToo) {
  EXPECT_THAT(render({"-o", "a.PNG"}), HasSubstr("wrote 1 frame, a.PNG"));
  EXPECT_THAT(render({"-o", "b.exr", "--golden", "trace4"}), HasSubstr("wrote 1 frame, b.exr"));
  EXPECT_EQ(folder.files(), 2);
  EXPECT_EQ(read_file(folder / "a.PNG").substr(1, 3), "PNG");
  EXPECT_EQ(read_file(folder / "b.exr").substr(0, 4), "\x76\x2f\x31\x01");
}

TEST_F(CliFormatsTest, AFolderWithAPicturesNameStaysOne) {
  std::filesystem::create_directory(folder / "old.png");
  render({"-o", "old.png", "--format", "jpg"});
  EXPECT_TRUE(std::filesystem::exists(folder / "old.png/frame_7223.jpg"));
}

TEST_F(CliFormatsTest, ASheetIsOfItsNamesFormat) {
  render({"--sheet", "a.jpg"});
  EXPECT_EQ(read_file(folder / "a.jpg").substr(0, 3), "\xff\xd8\xff");
}

TEST_F(CliFormatsTest, WhatCannotBeIsRefusedAndLeavesNothing) {
  for (const auto& [words, said] : std::vector<std::pair<Words, std::string>>{
           {{"-o", "o", "--format", "bmp"},
            "unknown picture format 'bmp' (there is: png, exr, tif, tiff, jpg, jpeg, webp)"},
           {{"-o", "o", "--format", "jpgg"}, "did you mean 'jpg'?"},
           {{"--sheet", "a.bmp"}, "unknown picture format 'bmp'"},
           {{"-o", "a.exr", "--frames", "2"},
            "-o a.exr is one picture; for 2 frames name a folder, -o DIR --format exr"},
           {{"-o", "a.exr", "--format", "tif"}, "-o a.exr says the format; leave out --format"},
           {{"-o", "a.jpg", "--overlay", "slack"}, "-o a.jpg is one picture; for --overlay"},
           {{"--gif", "a.gif", "--format", "exr"}, "add -o DIR"},
           {{"-o", "a.jpg", "--sheet", "a.jpg"}, "a.jpg is named for two outputs"},
           {{"-o", "none/a.exr"}, "cannot write none/a.exr: No such file or directory"}})
    EXPECT_THAT(render(words, 2), HasSubstr(said));
  EXPECT_EQ(folder.files(), 0);
}

TEST_F(CliFormatsTest, WithoutTheLibraryOnlyPngIsWrittenWhoeverRenders) {
  Program::Setting setting;
  setting.program = folder / "racebeam";
  std::filesystem::copy_file(RACEBEAM_BINARY, setting.program);
  for (const char* jobs : {"1", "2"}) {
    Program run(folder.path(),
                {"render", "demo", "--frames", "2", "-o", "o", "--format", "exr", "--jobs", jobs},
                setting);
    EXPECT_EQ(run.wait(), 3);
    EXPECT_THAT(run.err(), HasSubstr("libracebeam_images.so is neither in "));
    EXPECT_FALSE(std::filesystem::exists(folder / "o/manifest.json"));
  }
  Program png(folder.path(), {"render", "demo", "-o", "a.png"}, setting);
  EXPECT_EQ(png.wait(), 0) << png.err();
}

}  // namespace
}  // namespace racebeam
