// `racebeam view`: in a window of a real X server with real keys, without any screen, and wrong.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "tb/view/view_layout.h"
#include "tb/view/view_picture.h"
#include "tests/cli/program.h"
#include "tests/cli/view_pictures.h"
#include "tests/cli/x_server.h"

namespace racebeam {

void PrintTo(const Extent& size, std::ostream* out) { *out << size.width << " x " << size.height; }

namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

constexpr int Worst = 7223;

class CliViewTest : public testing::Test {
 protected:
  CliViewTest() {
    setenv("SDL_AUDIODRIVER", "dummy", 1);
    unsetenv("DISPLAY");
  }
  /// A run that opens no window.
  int view(std::vector<std::string> arguments, const std::string& driver = "dummy") {
    arguments.insert(arguments.begin(), "view");
    Program program(folder.path(), arguments,
                    {"", RLIM_INFINITY, false, "SDL_VIDEODRIVER=" + driver});
    const int code = program.wait();
    said = program.err();
    return code;
  }
  const ScratchFolder folder;
  std::string said;
};

TEST_F(CliViewTest, WindowShowsTheFramePixelForPixelAndObeysTheKeyboard) {
  const XServer server;
  const auto shows = [&](const Bytes& expected, int height = VisibleRows) {
    return eventually([&] { return server.window(VisibleColumns, height) == expected; });
  };
  Program program(folder.path(),
                  {"view", "demo", "--first", "7223", "--paused", "-o", "shots", "--scale", "1"},
                  {"", RLIM_INFINITY, false, "SDL_VIDEODRIVER=x11"});
  server.point_at_window();
  EXPECT_TRUE(shows(frame_of(Worst)));
  server.key("1");
  EXPECT_TRUE(shows(map_of(MapKind::Slack, Worst), VisibleRows + MapBarHeight));
  server.key("3");
  EXPECT_TRUE(shows(map_of(MapKind::Depth, Worst), VisibleRows + MapBarHeight));
  server.key("0");
  EXPECT_TRUE(shows(frame_of(Worst)));
  server.key("F12");
  EXPECT_TRUE(eventually([&] { return fs::exists(folder / "shots/view_7223.png"); }));
  EXPECT_EQ(read_rgb(folder / "shots/view_7223.png"), frame_of(Worst));
  server.key("period");
  EXPECT_TRUE(shows(frame_of(Worst + 1)));
  server.key("Right");
  EXPECT_TRUE(shows(frame_of(Worst + 61)));
  server.click_on_window(320, 240);
  server.key("Escape");
  EXPECT_EQ(program.wait(), 0) << program.err();
  EXPECT_EQ(program.err(),
            "racebeam: wrote shots/view_7223.png\n"
            "racebeam: to know why: racebeam explain demo --frame 7284 --pixel 320,240\n");
}

class CliViewScreenTest : public CliViewTest, public testing::WithParamInterface<Extent> {};

TEST_P(CliViewScreenTest, TheWindowLiesOnTheScreenWithPanelAndLegend) {
  const Extent screen = GetParam();
  const XServer server(screen.width, screen.height);
  Program program(folder.path(), {"view", "demo", "--first", "7223", "--paused"},
                  {"", RLIM_INFINITY, false, "SDL_VIDEODRIVER=x11"});
  server.point_at_window();
  /// The window is as large as that picture should be, and lies on the screen.
  const auto fits = [&](Extent picture) {
    const Extent size = scaled(picture, fit_scale(picture, window_room(screen)));
    return eventually([&] {
      const Box window = server.window_box();
      return window.size == size && window.left >= 0 && window.top >= 0 &&
             window.left + size.width <= screen.width && window.top + size.height <= screen.height;
    });
  };
  constexpr int Wide = VisibleColumns + PanelWidth, High = VisibleRows + MapBarHeight;
  EXPECT_TRUE(fits({VisibleColumns, VisibleRows}));
  server.key("t");
  EXPECT_TRUE(fits({Wide, VisibleRows}));
  server.key("1");
  EXPECT_TRUE(fits({Wide, High}));
  server.key("g");
  server.key("t");
  server.key("g");
  EXPECT_TRUE(fits({VisibleColumns, High}));
  server.key("0");
  EXPECT_TRUE(fits({VisibleColumns, VisibleRows}));
  server.key("q");
  EXPECT_EQ(program.wait(), 0) << program.err();
}

INSTANTIATE_TEST_SUITE_P(Screens, CliViewScreenTest,
                         testing::Values(Extent{1600, 1200}, Extent{1920, 1080}, Extent{1366, 768},
                                         Extent{1280, 720}),
                         [](const auto& screen) {
                           return std::to_string(screen.param.width) + "x" +
                                  std::to_string(screen.param.height);
                         });

TEST_F(CliViewTest, AWindowThatTheUserMadeLargerKeepsItsPixels) {
  const XServer server(1600, 1200);
  Program program(folder.path(), {"view", "demo", "--first", "7223", "--paused", "--scale", "1"},
                  {"", RLIM_INFINITY, false, "SDL_VIDEODRIVER=x11"});
  server.point_at_window();
  const auto becomes = [&](Extent size) {
    return eventually([&] { return server.window_box().size == size; });
  };
  EXPECT_TRUE(becomes({640, 480}));
  XServer::xdotool("search --name '^racebeam' windowsize 960 720");
  EXPECT_TRUE(becomes({960, 720}));
  server.key("t");
  EXPECT_TRUE(becomes(scaled({VisibleColumns + PanelWidth, VisibleRows}, 1.5)));
  server.key("t");
  EXPECT_TRUE(becomes({960, 720}));
  XServer::xdotool("search --name '^racebeam' windowmove 0 0 windowsize 1300 1000");
  EXPECT_TRUE(becomes({1300, 1000}));
  // Each pixel is two by two, in the middle of black.
  RgbImage expected(1300, 1000);
  const Bytes frame = frame_of(Worst);
  for (int y = 0; y < VisibleRows; ++y)
    for (int x = 0; x < VisibleColumns; ++x) {
      const std::uint8_t* pixel = &frame[3 * (y * VisibleColumns + x)];
      expected.fill(10 + 2 * x, 20 + 2 * y, 2, 2, {pixel[0], pixel[1], pixel[2]});
    }
  EXPECT_TRUE(eventually([&] { return server.window(1300, 1000) == bytes_of(expected); }));
  server.key("q");
  EXPECT_EQ(program.wait(), 0) << program.err();
}

TEST_F(CliViewTest, AChangedSceneFileIsShownAtTheSignalLevelToo) {
  const auto write = [&](const std::string& palette) {
    std::ofstream(folder / "scene.toml")
        << "frames = 9\n[[room]]\nid = \"a\"\ncentre = [0, 0, 0]\nhalf_size = [90, 60, 90]\n"
        << "[camera]\nroom = \"a\"\n[look]\npalette = [\"000\", \"110\", \"" << palette
        << "\", \"332\"]\n";
  };
  const auto rendered = [&](const std::string& to) {
    Program render(folder.path(), {"render", "scene.toml", "--first", "3", "-o", to});
    EXPECT_EQ(render.wait(), 0) << render.err();
    return read_rgb(folder / (to + "/frame_0003.png"));
  };
  write("320");
  const Bytes before = rendered("before");
  const XServer server;
  const auto shows = [&](const Bytes& expected) {
    return eventually([&] { return server.window(VisibleColumns, VisibleRows) == expected; });
  };
  Program program(
      folder.path(),
      {"view", "scene.toml", "--level", "signal", "--first", "3", "--paused", "--scale", "1"},
      {"", RLIM_INFINITY, false, "SDL_VIDEODRIVER=x11"});
  server.point_at_window();
  EXPECT_TRUE(shows(before));
  write("0312");  // a fault: the old picture stays, with the message above it
  EXPECT_TRUE(eventually([&] {
    const Bytes now = server.window(VisibleColumns, VisibleRows);
    return !now.empty() && now != before &&
           std::equal(before.end() - 900'000 / 2, before.end(), now.end() - 900'000 / 2);
  }));
  write("030");
  const Bytes after = rendered("after");
  EXPECT_NE(after, before);
  EXPECT_TRUE(shows(after));
  server.point_at_window();
  server.key("q");
  EXPECT_EQ(program.wait(), 0) << program.err();
}

TEST_F(CliViewTest, WithoutAScreenTheScreenshotIsTheRenderedFrame) {
  ASSERT_EQ(view({"demo", "--first", "7223", "--frames", "1", "--keys", "o"}), 0) << said;
  Program render(folder.path(), {"render", "demo", "--first", "7223", "-o", "r"});
  ASSERT_EQ(render.wait(), 0) << render.err();
  const std::string shot = read_file(folder / "view_7223.png");
  EXPECT_FALSE(shot.empty());
  EXPECT_EQ(shot, read_file(folder / "r/frame_7223.png"));
}

TEST_F(CliViewTest, WithoutAScreenAnOverlayIsTheMap) {
  ASSERT_EQ(view({"demo", "--first", "7223", "--frames", "1", "--keys", "2 o"}), 0) << said;
  EXPECT_EQ(read_rgb(folder / "view_7223.png"), map_of(MapKind::Cost, Worst));
}

TEST_F(CliViewTest, RtlInAUnitsPlaceShowsTheSameFrame) {
  ASSERT_EQ(
      view({"demo", "--first", "7223", "--frames", "1", "--use", "camera_unit=rtl", "--keys", "o"}),
      0)
      << said;
  EXPECT_EQ(read_rgb(folder / "view_7223.png"), frame_of(Worst));
}

TEST_F(CliViewTest, SignalLevelStopsAtAnyClock) {
  ASSERT_EQ(view({"demo", "--first", "60", "--level", "signal", "--paused", "--frames", "1",
                  "--keys", "l l k c b o"}),
            0)
      << said;
  Bytes expected = frame_of(60);  // two lines of the next frame, and a pixel, which is blanked
  const Bytes next = frame_of(61);
  std::copy_n(next.begin(), 2 * 3 * VisibleColumns, expected.begin());
  EXPECT_EQ(read_rgb(folder / "view_0061.png"), expected);
}

TEST_F(CliViewTest, KnobsChangeTheFrame) {
  ASSERT_EQ(view({"demo", "--first", "7223", "--frames", "1", "--set", "interval_stack_depth=1",
                  "--keys", "o"}),
            0)
      << said;
  Program render(folder.path(), {"render", "demo", "--first", "7223", "--set",
                                 "interval_stack_depth=1", "-o", "r"});
  ASSERT_EQ(render.wait(), 0) << render.err();
  EXPECT_EQ(read_file(folder / "view_7223.png"), read_file(folder / "r/frame_7223.png"));
  EXPECT_NE(read_rgb(folder / "view_7223.png"), frame_of(Worst));
}

TEST_F(CliViewTest, RecordsAGifOfTheFramesThatAreShown) {
  ASSERT_EQ(view({"demo", "--first", "60", "--frames", "9", "--keys", "v 0 0 v"}), 0) << said;
  Program render(folder.path(),
                 {"render", "demo", "--first", "60", "--frames", "3", "--gif", "r.gif"});
  ASSERT_EQ(render.wait(), 0) << render.err();
  EXPECT_EQ(read_file(folder / "view_0060.gif"), read_file(folder / "r.gif"));
}

TEST_F(CliViewTest, EndsAGifThatIsBeingRecordedWhenItEnds) {
  ASSERT_EQ(view({"demo", "--first", "60", "--frames", "2", "--keys", "v"}), 0) << said;
  EXPECT_THAT(said, HasSubstr("wrote view_0060.gif, 0.04 s in 2 pictures"));
}

TEST_F(CliViewTest, MistakesEndWithTwoAndSayWhatToDo) {
  const std::vector<std::pair<std::vector<std::string>, const char*>> mistakes{
      {{"dmo"}, "demo"},
      {{"demo", "--first", "12799"}, "0..12798"},
      {{"demo", "--frames", "0"}, "1.."},
      {{"demo", "--level", "signel"}, "signal"},
      {{"demo", "--level", "tlm", "--use", "stacks=rtl"}, "leave out --level"},
      {{"demo", "--use", "stack=rtl"}, "stacks"},
      {{"demo", "--set", "fifo_entries=1"}, "3..64"},
      {{"demo", "--keys", "1 spce"}, "space"},
      {{"demo", "--frames", "1", "--keys", "o", "-o", "/dev/null/shots"}, "cannot write"},
  };
  for (const auto& [arguments, hint] : mistakes) {
    EXPECT_EQ(view(arguments), 2) << hint;
    EXPECT_THAT(said, HasSubstr(hint));
  }
  EXPECT_EQ(folder.files(), 0);
}

TEST_F(CliViewTest, WithoutADisplayItEndsWithThreeAndNamesTheTerminal) {
  EXPECT_EQ(view({"demo"}, "x11"), 3);
  EXPECT_THAT(said, HasSubstr("racebeam view --term"));
  unsetenv("XDG_RUNTIME_DIR");
  unsetenv("WAYLAND_DISPLAY");
  EXPECT_EQ(view({"demo"}, ""), 3);
  EXPECT_EQ(said,
            "racebeam: no window can be opened: there is no display; set DISPLAY, or watch in the "
            "terminal: racebeam view --term\n");
}

TEST_F(CliViewTest, WithoutALoudspeakerItSaysSoOnceAndGoesOn) {
  setenv("SDL_AUDIODRIVER", "none such", 1);
  EXPECT_EQ(view({"demo", "--first", "60", "--frames", "3", "--keys", "m m"}), 0);
  EXPECT_THAT(said, testing::MatchesRegex("racebeam: no sound: [^\n]*\n"));
}

}  // namespace
}  // namespace racebeam
