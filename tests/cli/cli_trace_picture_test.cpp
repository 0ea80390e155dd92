// `racebeam trace --picture`: what is in its drawings, and what it does not draw.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <filesystem>
#include <set>
#include <sstream>

#include "tests/cli/program.h"
#include "tests/cli/wave.h"
#include "tests/support/svg.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using Arguments = std::vector<std::string>;

class CliTracePictureTest : public testing::Test {
 protected:
  void trace(Arguments arguments) {
    arguments.insert(arguments.begin(), "trace");
    Program run(folder.path(), arguments);
    EXPECT_EQ(run.wait(), 0) << run.err();
    said = run.err();
  }
  void refused(Arguments arguments, const std::string& words) {
    const int files = folder.files();
    arguments.insert(arguments.begin(), "trace");
    Program run(folder.path(), arguments);
    EXPECT_EQ(run.wait(), 2) << words;
    EXPECT_THAT(run.err(), HasSubstr(words));
    EXPECT_EQ(folder.files(), files) << "something is left of " << words;
  }
  Svg drawn(const std::string& name = "t.svg") { return Svg(read_file(folder / name)); }

  ScratchFolder folder;
  std::string said;
};

/// The values of a signal in the order of their time, as numbers of its format or as words.
std::vector<std::string> values_of(const Wave::Signal& signal, const std::string& format) {
  std::vector<std::string> all;
  for (const auto& [time, digits] : signal.changes) {
    std::ostringstream text;
    if (format == "word") {
      text << digits;
    } else if (const auto value = std::stoll(digits, nullptr, 2); format == "signed") {
      text << (digits[0] == '1' ? value - (1LL << digits.size()) : value);
    } else if (format == "hex") {
      text << "0x" << std::string((digits.size() + 3) / 4, '0');
      std::ostringstream hex;
      hex << std::hex << value;
      std::string padded = text.str();
      padded.replace(padded.size() - hex.str().size(), hex.str().size(), hex.str());
      text.str(padded);
    } else {
      text << value;
    }
    all.push_back(text.str());
  }
  return all;
}

TEST_F(CliTracePictureTest, EveryLaneHasTheValuesOfTheWaveformBesideIt) {
  for (const char* from : {"60:-1:1590", "1000:0:270", "7223:-240:370"}) {
    const std::string line(from, std::string(from).rfind(':'));
    const std::string last = line == "60:-1" ? "60:0:20" : line + ":400";
    trace({"demo", "--from", from, "--to", last, "--scope", "chip.u_subdivider", "--scope",
           "chip.u_ray_stepper", "-o", "t.vcd", "--picture", "t.svg"});
    EXPECT_THAT(said, HasSubstr("wrote t.vcd, t.gtkw and t.svg: "));
    const Wave wave(folder / "t.vcd");
    const Svg svg = drawn();
    std::set<std::string> lanes;
    for (const auto& lane : svg.lanes) lanes.insert(lane.path);
    for (const auto& [path, signal] : wave.signals)
      EXPECT_EQ(lanes.count(path),
                path == "beam.clk_i" || path == "beam.pixel" ||
                    (path.rfind("beam.", 0) != 0 && path.find(".clk_i") == std::string::npos))
          << path;
    const std::map<std::string, std::string> formats = {
        {"beam.pixel", "signed"},
        {"chip.u_subdivider.state_q_name", "word"},
        {"chip.u_subdivider.i1_q", "decimal"},
        {"chip.u_subdivider.idx2_o", "decimal"},
        {"chip.u_subdivider.tag_i", "hex"},
        {"chip.u_subdivider.d1_q", "hex"},
        {"chip.u_subdivider.sp_q", "decimal"},
        {"chip.u_ray_stepper.dr2_y_o", "signed"},
        {"chip.u_ray_stepper.g_axis[2].dr1_q", "signed"}};
    for (const auto& [path, format] : formats)
      EXPECT_EQ(svg[path].values(), values_of(wave[path], format)) << path << " from " << from;
    for (const auto& [path, signal] : wave.signals) {
      if (signal.bits != 1 || signal.kind == "string" || path.rfind("beam.", 0) == 0 ||
          !lanes.count(path))
        continue;
      const auto& bends = svg[path].level_xs;  // begin, two for each change, end
      ASSERT_EQ(bends.size(), 2 * signal.changes.size()) << path;
      std::size_t n = 0;
      for (const auto& [time, value] : signal.changes) {
        const auto clock = (time - wave.begin) * svg.grid.size() / (wave.end - wave.begin);
        if (n > 0) {
          EXPECT_DOUBLE_EQ(bends[2 * n - 1], svg.grid[clock]) << path;
        }
        ++n;
      }
    }
  }
}

TEST_F(CliTracePictureTest, TheRulerHasTheClocksOfTheBeam) {
  trace({"demo", "--from", "60:-1:1598", "--to", "60:0:2", "--depth", "1", "--scope", "chip.s*",
         "--picture", "t.svg"});
  EXPECT_EQ(folder.files(), 1) << "no waveform was asked for";
  const Svg svg = drawn();
  std::vector<std::string> clocks;
  for (const auto& clock : svg.clocks) clocks.push_back(clock.text);
  EXPECT_THAT(clocks, testing::ElementsAre("1598", "1599", "0", "1", "2"));
  EXPECT_EQ(svg.places.at(0).text, "frame 60, line -1");
  EXPECT_EQ(svg.grid.size(), 5u);
}

TEST_F(CliTracePictureTest, AWaveformIsDrawnAsItsWindowWas) {
  const Arguments scope = {"--scope", "chip.u_stacks", "--scope", "*.state_q"};
  Arguments first = {"demo", "--from", "60:0:900", "--to", "60:0:960", "--picture", "a.svg"};
  first.insert(first.end(), scope.begin(), scope.end());
  trace(first);
  trace({"demo", "--from", "60:0:900", "--to", "60:0:960", "-o", "t.vcd"});
  Arguments again = {"t.vcd", "--picture", "b.svg"};
  again.insert(again.end(), scope.begin(), scope.end());
  trace(again);
  EXPECT_EQ(read_file(folder / "a.svg"), read_file(folder / "b.svg"));
  EXPECT_EQ(drawn("a.svg")["chip.u_subdivider.state_q"].role, "register");
  EXPECT_EQ(drawn("a.svg")["chip.u_subdivider.state_q_name"].role, "words");
}

TEST_F(CliTracePictureTest, BothSidesOfALockstepAreDrawnAndAnFstToo) {
  trace({"demo", "--from", "60:0:900", "--to", "60:0:920", "--use", "stacks=lockstep", "--scope",
         "chip.u_stacks", "-o", "t.fst", "--picture", "t.svg"});
  EXPECT_EQ(folder.files(), 3);
  const Svg svg = drawn();
  EXPECT_EQ(svg["chip.u_stacks.rtl.top_i2_o"].values(), svg["chip.u_stacks.top_i2_o"].values());
  EXPECT_EQ(svg.headings.back().text, "u_stacks.rtl");
}

TEST_F(CliTracePictureTest, RefusesWhatNobodyCouldReadAndLeavesNothing) {
  const auto window = [&](Arguments more, const std::string& words) {
    more.insert(more.begin(), {"demo", "--from", "60:0:1"});
    refused(more, words);
  };
  window({"--to", "60:0:401", "--picture", "t.svg", "-o", "t.vcd"}, "--to FRAME:LINE:CLOCK");
  window({"--to", "60:0:4", "--picture", "t.svg", "-o", "t.vcd"}, "choose some with --scope");
  window({"--to", "60:0:4", "--picture", "t.svg"}, "choose some with --scope");
  window({"--to", "60:0:4", "--picture", "t.png", "--depth", "1"}, "ends with .svg");
  window({"--to", "60:0:4", "--picture", "no/t.svg", "--scope", "*_q", "-o", "t.vcd"},
         "cannot write no/t.svg");
  window({"--to", "60:0:4"}, "--picture FILE.svg, says where to write");
  trace({"demo", "--from", "60:0", "--to", "60:0", "-o", "t.vcd"});
  refused({"t.vcd", "--picture", "t.svg", "--scope", "*.i1_q"}, "more than 400 clocks");
  refused({"t.vcd", "--picture", "t.svg", "--from", "60:0"}, "only --scope and --depth");
  refused({"t.vcd", "--picture", "t.svg", "--scope", "nothing"}, "no signal is under --scope");
  refused({"t.vcd", "--picture", "t.svg", "--depth", "-1"}, "--depth -1 is out of range");
  refused({"t.vcd"}, "--picture FILE.svg draws it");
  refused({"none.vcd", "--picture", "t.svg"}, "cannot read none.vcd");
  refused({"t.fst", "--picture", "t.svg"}, "fst2vcd");
}

}  // namespace
}  // namespace racebeam
