// What `racebeam trace` writes, opened by a real GTKWave: its signals, groups, values and pixels.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <utility>

#include "tests/cli/gtkwave.h"
#include "tests/cli/program.h"
#include "tests/cli/wave.h"
#include "tests/cli/x_server.h"

namespace racebeam {
namespace {

using Arguments = std::vector<std::string>;
using Rgb = std::array<int, 3>;
using testing::ElementsAreArray;

constexpr int Width = 1440, Height = 900;
constexpr Rgb Violet{155, 0, 255}, Orange{255, 127, 0}, Yellow{255, 255, 0}, Green{0, 255, 0};

/// A signal of a save file, as a test reads it.
struct Shown {
  std::string group, path;  // with its range
  unsigned flags;
  bool operator==(const Shown& other) const {
    return group == other.group && path == other.path && flags == other.flags;
  }
};
void PrintTo(const Shown& shown, std::ostream* out) {
  *out << shown.group << ": " << shown.path << " @" << std::hex << shown.flags << std::dec;
}

std::vector<Shown> read_save_file(const std::string& path) {
  std::istringstream in(read_file(path));
  std::vector<Shown> all;
  std::string group;
  unsigned flags = 0;
  for (std::string line; std::getline(in, line);) {
    if (line[0] == '@') flags = static_cast<unsigned>(std::stoul(line.substr(1), nullptr, 16));
    else if (line[0] == '-') group = line.substr(1);
    else if (line[0] != '[' && line[0] != '*') all.push_back({group, line, flags});
  }
  return all;
}

/// What the flags of a row make of digits or a word.
std::string as_shown(const std::string& digits, unsigned flags) {
  if (flags & 0x800) return digits;
  const std::uint64_t value = std::stoull(digits, nullptr, 2);
  if (flags & 0x400) {
    const bool negative = digits[0] == '1' && digits.size() > 1;
    return std::to_string(static_cast<long long>(value) - (negative ? 1LL << digits.size() : 0));
  }
  if (flags & 0xc) return std::to_string(value);  // decimal, or one bit
  std::ostringstream hex;
  hex << std::hex << std::uppercase << value;
  return std::string((digits.size() + 3) / 4 - hex.str().size(), '0') + hex.str();
}

class CliGtkWaveTest : public testing::Test {
 protected:
  Wave trace(const std::string& file, const Arguments& more, const std::string& dump = {}) {
    Arguments arguments = {"trace", "demo", "-o", file};
    arguments.insert(arguments.end(), more.begin(), more.end());
    Program run(folder.path(), arguments);
    EXPECT_EQ(run.wait(), 0) << run.err();
    return Wave(folder / (dump.empty() ? file : dump));
  }

  /// The rows of all groups, unfolded, against the save file and the waveform at these times.
  void expect_what_is_saved(GtkWave& gtkwave, const std::string& save, const Wave& wave,
                            const std::vector<std::uint64_t>& times) {
    EXPECT_EQ(gtkwave.ask("getNumFacs"), std::to_string(wave.signals.size()));
    const auto first = gtkwave.rows();
    for (std::size_t n = 0; n < first.size(); ++n)
      if (first[n].begins() && first[n].folded()) gtkwave.unfold(n);
    std::istringstream displayed(gtkwave.ask("getDisplayedSignals"));
    const std::vector<std::string> paths{std::istream_iterator<std::string>(displayed), {}};
    for (const std::uint64_t time : times) {
      gtkwave.run("gtkwave::setMarker " + std::to_string(time));
      std::vector<Shown> shown;
      std::string group;
      for (const GtkWave::Row& row : gtkwave.rows()) {
        if (row.begins()) group = row.name;
        if (row.begins() || row.ends()) continue;
        ASSERT_LT(shown.size(), paths.size());
        const std::string& path = paths[shown.size()];
        const std::string ranged = path.substr(path.size() - row.name.size());
        EXPECT_EQ(row.name, ranged) << path;
        shown.push_back({group, path, row.flags & ~1u});  // bit 0: highlighted
        const bool is_range = path.back() == ']' && path.find(':') != std::string::npos;
        const auto& signal = wave[is_range ? path.substr(0, path.rfind('[')) : path];
        EXPECT_EQ(row.value, as_shown(signal.at(time), row.flags)) << path << " at " << time;
      }
      EXPECT_THAT(shown, ElementsAreArray(read_save_file(folder / save)));
    }
  }

  /// The screen as soon as it is `good`, or as it is after half a minute.
  template <class Good>
  bool screen_becomes(const XServer& server, const Good& good) {
    const bool is_good = eventually([&] {
      const std::vector<std::uint8_t> before = std::exchange(screen, server.screen());
      return !screen.empty() && screen == before && good();  // or it is half drawn
    });
    if (!is_good) {
      const std::string path = std::string(test_info_->name()) + ".png";
      if (const auto out = OIIO::ImageOutput::create(path);
          out && out->open(path, OIIO::ImageSpec(Width, Height, 3, OIIO::TypeDesc::UINT8)))
        out->write_image(OIIO::TypeDesc::UINT8, screen.data());
      ADD_FAILURE() << "see " << path;
    }
    return is_good;
  }
  bool is(int x, int y, const Rgb& colour) const {
    const std::size_t at = 3 * (static_cast<std::size_t>(y) * Width + static_cast<std::size_t>(x));
    return screen[at] == colour[0] && screen[at + 1] == colour[1] && screen[at + 2] == colour[2];
  }
  long pixels(const Rgb& colour) const {
    long count = 0;
    for (int y = 0; y < Height; ++y)
      for (int x = 0; x < Width; ++x) count += is(x, y, colour);
    return count;
  }
  /// Where the edges of a bit are drawn through row `y`.
  std::vector<int> edges(int y, const Rgb& colour) const {
    std::vector<int> at;
    for (int x = 0; x < Width; ++x)
      if (is(x, y, colour) && is(x, y - 4, colour) && is(x, y + 4, colour)) at.push_back(x);
    return at;
  }
  /// Rows of pixels through the middle of square waves in violet, the colour of inputs.
  std::vector<int> clocks() const {
    std::vector<int> rows;
    for (int y = 20; y < Height - 20; ++y)
      if (edges(y, Violet).size() > 9 && (rows.empty() || y > rows.back() + 20)) rows.push_back(y);
    return rows;
  }

  const ScratchFolder folder;
  std::vector<std::uint8_t> screen;
  const testing::TestInfo* const test_info_ = testing::UnitTest::GetInstance()->current_test_info();
};

TEST_F(CliGtkWaveTest, ShowsEverySignalOfTheChipInItsGroupWithItsValueAndFormat) {
  const Wave wave = trace("t.vcd", {"--from", "7223:-240:370", "--to", "7223:-240:380"});
  const XServer server(Width, Height);
  GtkWave gtkwave({folder / "t.vcd", folder / "t.gtkw"});
  expect_what_is_saved(gtkwave, "t.gtkw", wave, {wave.begin, wave.end - 30'000, wave.end - 1});
}

TEST_F(CliGtkWaveTest, ShowsRtlAndBothSidesOfALockstep) {
  const Wave wave = trace("t.vcd", {"--from", "60:0:900", "--to", "60:0:910", "--use",
                                    "stacks=lockstep,subdivider=rtl,ray_stepper=rtl"});
  const XServer server(Width, Height);
  GtkWave gtkwave({folder / "t.vcd", folder / "t.gtkw"});
  expect_what_is_saved(gtkwave, "t.gtkw", wave, {wave.begin + 30'000, wave.end - 1});
}

TEST_F(CliGtkWaveTest, TheSaveFileFindsItsFstByItselfWhereverBothAreMoved) {
  const Arguments window = {"--from", "60:0:900", "--to", "60:0:910", "--scope", "chip.u_s*"};
  const Wave wave = trace("t.vcd", window);
  const XServer server(Width, Height);
  for (const std::string& output : {std::string("t.fst"), folder / "t.fst"}) {
    Arguments words = {"trace", "demo", "-o", output};
    words.insert(words.end(), window.begin(), window.end());
    Program run(folder.path(), words);
    ASSERT_EQ(run.wait(), 0) << run.err();
    EXPECT_THAT(read_file(folder / "t.gtkw"),
                testing::HasSubstr("\n[dumpfile] \"t.fst\"\n[savefile] \"t.gtkw\"\n"));
    std::filesystem::create_directory(folder / "moved");
    for (const char* name : {"t.fst", "t.gtkw"})
      std::filesystem::rename(folder / name, folder / "moved/" + name);
    GtkWave gtkwave({folder / "moved/t.gtkw"});
    EXPECT_EQ(gtkwave.ask("getDumpFileName"), folder / "moved/t.fst");
    expect_what_is_saved(gtkwave, "moved/t.gtkw", wave, {wave.begin, wave.end - 1});
  }
}

TEST_F(CliGtkWaveTest, AllOfALongWindowIsSeenAtFirst) {
  const Wave lines = trace("t.vcd", {"--from", "60:0", "--to", "60:2", "--scope", "chip.room"});
  const Wave frames = trace(
      "f.vcd", {"--from", "60:-273", "--to", "79:251", "--level", "tlm", "--scope", "*.frame"});
  const XServer server(Width, Height);
  for (const auto& [save, wave] : {std::pair{"t.gtkw", &lines}, {"f.gtkw", &frames}}) {
    GtkWave gtkwave({folder / save});
    const auto length = static_cast<double>(wave->end - wave->begin);
    EXPECT_EQ(gtkwave.number("getWindowStartTime"), static_cast<double>(wave->begin)) << save;
    const double end = gtkwave.number("getWindowEndTime");
    EXPECT_GE(end, static_cast<double>(wave->end) - length / 50) << save;
    EXPECT_LE(end, static_cast<double>(wave->end) + length / 2) << save << " is not lost in space";
  }
}

TEST_F(CliGtkWaveTest, BothSidesOfADifferenceAreTheFirstRows) {
  std::string text = read_file(RACEBEAM_SOURCE_DIR "/rtl/beam/stacks.sv");
  const std::string right = "(n + 1) % IntervalStackDepth";
  std::ofstream(folder / "mine.sv") << text.replace(text.find(right), right.size(), "0");
  Program run(folder.path(), {"trace", "demo", "--use", "stacks=lockstep:mine.sv", "--around",
                              "mismatch", "-o", "t.vcd"});
  ASSERT_EQ(run.wait(), 1) << run.err();
  const XServer server(Width, Height);
  GtkWave gtkwave({folder / "t.gtkw"});
  const auto rows = gtkwave.rows();
  ASSERT_GT(rows.size(), 5u);
  EXPECT_THAT(rows[0].name, testing::StartsWith("differs: chip.u_stacks.top_"));
  EXPECT_FALSE(rows[0].folded());
  EXPECT_THAT(rows[1].name, testing::StartsWith("model top_"));
  EXPECT_THAT(rows[2].name, testing::StartsWith("RTL top_"));
  EXPECT_NE(rows[1].value, rows[2].value) << "at the marker";
  EXPECT_TRUE(rows[3].ends());
  EXPECT_EQ(rows[4].name, "inputs of chip.u_stacks");
  constexpr Rgb Red{255, 0, 0};
  EXPECT_TRUE(screen_becomes(server, [&] { return pixels(Red) > 100; }));
}

TEST_F(CliGtkWaveTest, DrawsEdgesAtTheirClocksInTheColoursOfTheSaveFile) {
  const Wave wave = trace(
      "t.vcd", {"--from", "1000:0:270", "--to", "1000:0:290", "--scope", "chip.u_subdivider"});
  const double period = (wave.end - wave.begin) / 21.;
  const XServer server(Width, Height);
  GtkWave gtkwave({folder / "t.vcd", folder / "t.gtkw"});
  ASSERT_TRUE(screen_becomes(server, [&] { return clocks().size() == 2; }));
  const std::vector<int> clock = edges(clocks()[0], Violet);
  const double pixel = std::pow(2, -gtkwave.number("getZoomFactor")) / 200;  // picoseconds
  EXPECT_EQ(gtkwave.number("getWindowStartTime"), static_cast<double>(wave.begin));
  EXPECT_GE(gtkwave.number("getWindowEndTime"), static_cast<double>(wave.end)) << "all of it";
  ASSERT_GE(clock.size(), 41u) << "21 clocks, and the window's end may be cut";
  for (std::size_t n = 0; n < clock.size(); ++n)
    EXPECT_NEAR(clock[n] - clock[0], n * period / 2 / pixel, 1.5) << "edge " << n;

  const auto rows = gtkwave.rows();  // clk_i twice: of the beam, and of the unit
  const auto row_of = [&](const std::string& name, std::size_t from = 0) {
    for (std::size_t n = from; n < rows.size(); ++n)
      if (rows[n].name == name) return static_cast<int>(n);
    return -1;
  };
  const int beam = row_of("clk_i"), unit = row_of("clk_i", static_cast<std::size_t>(beam) + 1);
  const double row_height = (clocks()[1] - clocks()[0]) / static_cast<double>(unit - beam);
  for (const char* name : {"emit_o", "descend_o", "climb_o"}) {
    const auto y = static_cast<int>(clocks()[0] + (row_of(name) - beam) * row_height);
    std::vector<double> expected;
    for (const auto& [time, value] : wave["chip.u_subdivider." + std::string(name)].changes)
      if (time > wave.begin) expected.push_back(clock[0] + (time - wave.begin) / pixel);
    const std::vector<int> drawn = edges(y, Orange);
    EXPECT_GE(expected.size(), 2u);
    ASSERT_THAT(drawn, testing::SizeIs(testing::Ge(expected.size()))) << name;
    for (const double at : expected)
      EXPECT_TRUE(
          std::any_of(drawn.begin(), drawn.end(), [&](int x) { return std::abs(x - at) < 1.5; }))
          << name << " at " << at;
  }
  EXPECT_GT(pixels(Yellow), 300) << "the words";
}

TEST_F(CliGtkWaveTest, OpensAtTheTriggerAndShowsNothingWithoutTheSaveFile) {
  const Wave wave = trace("t.vcd", {"--around", "first-restart", "--from", "7223:-240"});
  const XServer server(Width, Height);
  {
    GtkWave gtkwave({folder / "t.gtkw"});
    EXPECT_TRUE(screen_becomes(server, [&] {
      return clocks().size() == 1 && pixels(Yellow) > 300 && pixels(Green) > 3000;
    }));
    const auto marker = static_cast<std::uint64_t>(gtkwave.number("getMarker"));
    EXPECT_EQ(wave["chip.restart"].at(marker), "1");
    EXPECT_EQ(wave["chip.restart"].at(marker - 1), "0");
    EXPECT_LT(gtkwave.number("getWindowStartTime"), marker);
    EXPECT_GT(gtkwave.number("getWindowEndTime"), marker);
    const auto rows = gtkwave.rows();
    std::set<std::string> open;
    for (const auto& row : rows)
      if (row.begins() && !row.folded()) open.insert(row.name);
    EXPECT_EQ(open, (std::set<std::string>{"beam", "overview"}));
  }
  GtkWave bare({folder / "t.vcd"});
  EXPECT_EQ(bare.ask("getTotalNumTraces"), "0");
  EXPECT_TRUE(screen_becomes(server, [&] { return pixels({32, 32, 112}) > 100; })) << "its grid";
  EXPECT_EQ(pixels(Violet), 0);
  EXPECT_EQ(pixels(Yellow), 0);
}

}  // namespace
}  // namespace racebeam
