// `racebeam render --tt`: our own chip and a stranger's through the same door.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <fstream>

#include "tests/cli/program.h"
#include "tests/support/read_picture.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using Words = std::vector<std::string>;
namespace fs = std::filesystem;

const std::string Own = RACEBEAM_SOURCE_DIR "/rtl";
const std::string Bars = RACEBEAM_SOURCE_DIR "/tests/tt/bars";

class CliTtTest : public testing::Test {
 protected:
  Words render(const Words& more) {
    Words words = {"render", "--overwrite"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  /// Copies the bars to the folder `bars`, with one place of a file changed.
  void change(const std::string& file, const std::string& from, const std::string& to) {
    fs::remove_all(folder / "bars");
    fs::copy(Bars, folder / "bars", fs::copy_options::recursive);
    std::string text = read_file(folder / "bars/" + file);
    const auto at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    std::ofstream(folder / "bars/" + file) << text.replace(at, from.size(), to);
  }
  void expect_end(const Words& words, int code, const Words& said) {
    Program run(folder.path(), render(words));
    EXPECT_EQ(run.wait(), code);
    for (const std::string& text : said) EXPECT_THAT(run.err(), HasSubstr(text));
  }
  /// The bars with info.yaml changed are refused.
  void expect_info_refused(const std::string& from, const std::string& to, const Words& said) {
    change("info.yaml", from, to);
    expect_end({"--tt", "bars"}, 2, said);
    EXPECT_FALSE(fs::exists(folder / "racebeam_out"));
  }
  /// The bars with a source changed end with this exit code.
  void expect_source_end(const std::string& file, const std::string& from, const std::string& to,
                         int code, const Words& said) {
    change("src/" + file, from, to);
    expect_end({"--tt", "bars"}, code, said);
  }

  ScratchFolder folder;
};

TEST_F(CliTtTest, OwnChipGivesTheDemoInPicturePinsAndSound) {
  Program rtl(folder.path(), render({"--tt", Own, "--frames", "2", "--first", "0", "--crc",
                                     "--json", "-o", "rtl", "--wav", "rtl.wav"}));
  Program model(folder.path(), render({"demo", "--frames", "2", "--crc", "--json", "-o", "model",
                                       "--wav", "model.wav"}));
  ASSERT_EQ(rtl.wait(), 0) << rtl.err();
  ASSERT_EQ(model.wait(), 0) << model.err();
  for (int frame = 0; frame < 2; ++frame)
    for (const char* crc : {"image_crc32", "pins_crc32"})
      EXPECT_EQ(rtl.json()["frames"][frame][crc], model.json()["frames"][frame][crc]);
  for (const char* name : {"/frame_0000.png", "/frame_0001.png", ".wav"})
    EXPECT_EQ(read_file(folder / ("rtl" + std::string(name))),
              read_file(folder / ("model" + std::string(name))));
}

TEST_F(CliTtTest, OwnChipsSpeedPinsAreInputs) {
  Program rtl(folder.path(), render({"--tt", Own, "--ui", "13", "--crc", "--json", "-o", "rtl"}));
  Program model(folder.path(), render({"demo", "--set", "speed=5", "--set", "interlace=off",
                                       "--crc", "--json", "-o", "model"}));
  ASSERT_EQ(rtl.wait(), 0) << rtl.err();
  ASSERT_EQ(model.wait(), 0) << model.err();
  EXPECT_EQ(rtl.json()["frames"][0]["pins_crc32"], model.json()["frames"][0]["pins_crc32"]);
  EXPECT_EQ(rtl.json()["chip"]["ui_in"], 13);
}

TEST_F(CliTtTest, StrangersPictureIsRightInEveryPixel) {
  const int palette[] = {0x30, 0x0c, 0x03, 0x3c, 0x0f, 0x33, 0x3f, 0x2a};
  for (const int ui : {0, 0x15}) {
    const std::string out = "out" + std::to_string(ui);
    Program run(folder.path(), render({"--tt", Bars, "--ui", std::to_string(ui), "-o", out}));
    ASSERT_EQ(run.wait(), 0) << run.err();
    const Picture picture = read_picture(folder / (out + "/frame_0000.png"));
    ASSERT_EQ(picture.size(), 640u * 480);
    for (int y = 0; y < 480; ++y)
      for (int x = 0; x < 640; ++x)
        ASSERT_EQ(picture[y * 640 + x], palette[(x / 80) ^ (y / 60)] ^ ui) << x << ", " << y;
  }
}

TEST_F(CliTtTest, StatisticsTellSyncsPinsAndColours) {
  Program run(folder.path(), render({"--tt", Bars, "--first", "1", "--frames", "2", "--every", "2",
                                     "--uio", "5", "--crc", "--json", "-o", "out"}));
  ASSERT_EQ(run.wait(), 0) << run.err();
  const Json stats = run.json();
  EXPECT_EQ(stats, read_json(folder / "out/stats.json"));
  EXPECT_EQ(stats["schema"], "racebeam-pins");
  EXPECT_EQ(stats["version"], 1);
  EXPECT_EQ(stats["chip"]["top_module"], "tt_um_bars");
  EXPECT_EQ(stats["chip"]["clock_hz"], 25175000);
  EXPECT_EQ(stats["chip"]["uio_in"], 5);
  const Json& syncs = stats["syncs"];
  EXPECT_EQ(syncs["clocks_per_pixel"], 1);
  EXPECT_EQ(syncs["hsync"],
            (Json{{"period_clocks", 800}, {"pulse_clocks", 96}, {"polarity", "positive"}}));
  EXPECT_EQ(syncs["vsync"],
            (Json{{"period_clocks", 420000}, {"pulse_clocks", 1600}, {"polarity", "positive"}}));
  EXPECT_EQ(syncs["picture_late_clocks"], -1) << "its syncs pass a register, its colours do not";
  ASSERT_EQ(stats["frames"].size(), 2u);
  EXPECT_EQ(stats["frames"][1]["frame"], 3);
  EXPECT_EQ(stats["frames"][0]["image_crc32"], stats["frames"][1]["image_crc32"]);
  for (const Json& counts : {stats["frames"][0], stats["frames"][1], stats["total"]}) {
    const int frames = counts.contains("frames") ? counts["frames"].get<int>() : 1;
    const Json& pins = counts["pins"];
    EXPECT_EQ(counts["clocks"], frames * 420000);
    EXPECT_EQ(counts["colours"], 8);
    EXPECT_EQ(pins["uo[7]"]["toggles"], frames * 2 * 525);
    EXPECT_EQ(pins["uo[7]"]["high"], 0.12);
    EXPECT_EQ(pins["uo[3]"]["toggles"], frames * 2);
    EXPECT_EQ(pins["uio[0]"]["high"], 1);
    EXPECT_EQ(pins["uio[0]"]["enabled"], 0);
    EXPECT_EQ(pins["uio[1]"]["high"], 0);
    EXPECT_EQ(pins["uio[7]"]["toggles"], frames * 32);
  }
  EXPECT_EQ(read_json(folder / "out/manifest.json")["scene"], Bars);
}

TEST_F(CliTtTest, TableTellsWhatWasFound) {
  Program run(folder.path(),
              render({"--tt", Bars, "--gif", "a.gif", "--wav", "a.wav", "--sheet", "a.png"}));
  ASSERT_EQ(run.wait(), 0) << run.err();
  EXPECT_THAT(run.out(),
              HasSubstr("hsync positive, every 800 clocks; vsync positive, every 420000"));
  EXPECT_THAT(run.out(), HasSubstr("1 clock too early"));
  EXPECT_THAT(run.out(), HasSubstr("uo[7]   hsync          1050"));
  EXPECT_EQ(run.err(), "racebeam: wrote 1 frame, a.gif, a.wav, a.png\n");
  EXPECT_EQ(read_file(folder / "a.gif").substr(0, 6), "GIF89a");
  EXPECT_EQ(read_file(folder / "a.wav").size(), 44u + 2 * 800) << "420000 clocks at 48 kHz";
}

TEST_F(CliTtTest, SourcesMayLieBesideInfoAndSoundMayBeMissing) {
  change("src/tt_um_bars.v", "uio_oe = 8'h80", "uio_oe = 8'h00");
  for (const auto& file : fs::directory_iterator(folder / "bars/src"))
    fs::rename(file.path(), folder / "bars" / file.path().filename());
  expect_end({"--tt", "bars", "--wav", "a.wav"}, 0, {"uio_oe[7] was never 1", "silence"});
}

TEST_F(CliTtTest, RefusesFoldersThatAreNoProject) {
  expect_end({"--tt", "none"}, 2, {"there is no folder 'none'"});
  expect_end({"--tt", "."}, 2, {"there is no ./info.yaml", "Tiny Tapeout project"});
  fs::create_directory(folder / "empty");
  std::ofstream(folder / "empty/info.yaml").flush();
  expect_end({"--tt", "empty"}, 2, {"empty/info.yaml: there is no section `project:`"});
  expect_info_refused("  tiles", " tiles", {"bars/info.yaml:8: ", "must be YAML"});
  expect_info_refused("project:", "projects:", {"bars/info.yaml", "no section `project:`"});
  expect_info_refused("  top_module: \"tt_um_bars\"\n", "",
                      {"bars/info.yaml:3: project.top_module is missing"});
  expect_info_refused("\"tt_um_bars\"", "[a]", {"bars/info.yaml:9: project.top_module must be"});
  expect_info_refused("\"tt_um_bars\"", "\"\"", {"bars/info.yaml:9: project.top_module must be"});
  expect_info_refused("\"tt_um_bars\"", "bars", {"info.yaml:9: project.top_module is 'bars'"});
  expect_info_refused("\"tt_um_bars\"", "\"tt_um_x;y\"", {"is 'tt_um_x;y', must be"});
  expect_info_refused("  source_files:\n", "  sources:\n", {"project.source_files is missing"});
  expect_info_refused("\n    - \"tt_um_bars.v\"\n    - \"hvsync_generator.v\"", " x.v",
                      {"bars/info.yaml:10: project.source_files must be a list"});
  expect_info_refused("\"tt_um_bars.v\"", "\"\"", {"info.yaml:11: project.source_files must be"});
  expect_info_refused("hvsync_generator.v", "hvsync.v",
                      {"bars/info.yaml:12: there is no source file bars/src/hvsync.v"});
  expect_info_refused("25175000", "fast", {"bars/info.yaml:7: project.clock_hz must be"});
  expect_info_refused("25175000", "-1", {"bars/info.yaml:7: project.clock_hz must be"});
  expect_info_refused("25175000", "[1]", {"bars/info.yaml:7: project.clock_hz must be"});
  expect_end({"--tt", Bars, "--clock-hz", "0"}, 2, {"--clock-hz 0", "1000000..1000000000 Hz"});
}

TEST_F(CliTtTest, RefusesRtlThatIsNoTile) {
  expect_source_end("tt_um_bars.v", "endmodule", "endmodul", 2,
                    {"cannot be verilated", "tt_um_bars.v:40", "syntax error"});
  expect_source_end(
      "tt_um_bars.v", "[7:0] uio_in", "[3:0] uio_in", 2,
      {"does not fit a Tiny Tapeout tile", "port uio_in is 4 bits wide instead of 8"});
  expect_source_end("tt_um_bars.v", "input wire ena,", "", 2,
                    {"port ena is missing: input, 1 bit"});
  expect_source_end("tt_um_bars.v", "hvsync_generator hvsync_gen", "vga_timing hvsync_gen", 2,
                    {"Cannot find file containing module: 'vga_timing'"});
  expect_source_end("tt_um_bars.v", "initial ", "initial $stop; initial ", 2,
                    {"the RTL of tt_um_bars has ended", "tt_um_bars.v:20: $stop"});
  expect_source_end("tt_um_bars.v", "initial ", "initial $finish; initial ", 2,
                    {"tt_um_bars.v:20: $finish"});
  setenv("RACEBEAM_RTL_SECONDS", "0.5", 1);
  change("src/tt_um_bars.v", "initial ", "initial forever $c(\"\"); initial ");
  expect_end({"--tt", "bars", "--trust"}, 2, {"tt_um_bars does not return from clock 0"});
  EXPECT_FALSE(fs::exists(folder / "racebeam_out"));
}

TEST_F(CliTtTest, SyncFaultsEndWith1) {
  expect_source_end("tt_um_bars.v", "{hsync", "{1'b0", 1,
                    {"hsync, uo_out[7], has no pulses in the "});
  expect_source_end("video.vh", "16 + 96 - 1", "16 + 95 - 1", 1,
                    {"wrote 1 frame", "the syncs broke the mode in 525 clocks; first, frame 0",
                     "clock 112: hsync is 0, must be 1 (sync pulse"});
  expect_source_end("hvsync_generator.v", "vpos <= `V_SYNC_END", "vpos < `V_SYNC_END", 1,
                    {"vsync is 0, must be 1 (sync pulse, which is line 250"});
}

TEST_F(CliTtTest, RefusesOptionsOfScenes) {
  for (const Words& words :
       {Words{"demo"}, {"--set", "speed=1"}, {"--use", "all=rtl"}, {"--golden", "trace4"}}) {
    Words all = {"--tt", Bars};
    all.insert(all.end(), words.begin(), words.end());
    expect_end(
        all, 2,
        {"--tt runs a chip of its own; leave out ", words[0] == "demo" ? "the scene" : words[0]});
  }
  expect_end({"--tt", Bars, "--ui", "256"}, 2, {"--ui 256", "0..255"});
  expect_end({"--tt", Bars, "--uio", "-1"}, 2, {"--uio -1", "0..255"});
  expect_end({"--tt", Bars, "--first", "999999", "--frames", "2"}, 2, {"beyond 999999"});
  expect_end({"--tt", Bars, "--wav", "a.wav", "--every", "2"}, 2, {"--wav", "--every"});
  expect_end({"--tt", ""}, 2, {"--tt", "empty"});
  expect_end({"demo", "--ui", "1"}, 2, {"--ui, --uio and --inputs", "--tt"});
}

TEST_F(CliTtTest, MissingVerilatorEndsWith3) {
  Program run(folder.path(), render({"--tt", Bars}),
              {{}, RLIM_INFINITY, false, "PATH=/no/such/folder"});
  EXPECT_EQ(run.wait(), 3);
  EXPECT_THAT(run.err(), HasSubstr("install the package `verilator`"));
}

TEST_F(CliTtTest, InterruptionKeepsWholeFrames) {
  Program run(folder.path(), render({"--tt", Bars, "--frames", "100000", "-o", "out"}));
  for (int i = 0; i < 3000 && !fs::exists(folder / "out/frame_0001.png"); ++i) usleep(10000);
  run.signal(SIGINT);
  EXPECT_EQ(run.wait(), 130);
  EXPECT_THAT(run.err(), HasSubstr("stopped early; kept "));
  EXPECT_GE(read_json(folder / "out/stats.json")["frames"].size(), 2u);
}

}  // namespace
}  // namespace racebeam
