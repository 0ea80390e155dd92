// The first difference of model and RTL as `racebeam verify` and `trace` leave it: the waveform on
// the axis of its frame, the save file, the table.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <fstream>

#include "tb/base/project_folder.h"
#include "tests/cli/cli_trace_bench.h"
#include "tests/cli/traced_window.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using testing::Not;
using Words = std::vector<std::string>;

class CliDifferenceTest : public CliTraceBench {
 protected:
  /// The RTL of a unit with one place changed, as mine.sv.
  void write_mine(const std::string& unit, const std::string& right, const std::string& wrong) {
    std::string text = read_file(rtl_file(unit));
    const auto at = text.find(right);
    ASSERT_NE(at, std::string::npos) << right;
    std::ofstream(folder / "mine.sv") << text.replace(at, right.size(), wrong);
  }
  void write_faulty_stacks() {
    write_mine("stacks", "(n + 1) % IntervalStackDepth", "n % IntervalStackDepth");
  }
  int run(const Words& words, const Program::Setting& setting = {}) {
    Program program(folder.path(), words, setting);
    const int code = program.wait();
    said = program.err();
    out = program.out();
    return code;
  }
  /// Paths and names of the first rows of a save file, and where its marker stands.
  struct Saved {
    std::string title;
    Words rows;
    std::uint64_t marker = 0;
  };
  Saved saved(const std::string& file) {
    std::istringstream in(read_file(folder / file));
    Saved all;
    for (std::string line; std::getline(in, line);) {
      std::istringstream words(line);
      std::string first;
      words >> first;
      if (first[0] == '*') words >> all.marker;
      else if (line[0] == '-' && all.title.empty()) all.title = line.substr(1);
      else if (line[0] != '@' && line[0] != '[' && line[0] != '-') all.rows.push_back(line);
    }
    return all;
  }
  static std::string with_range(const std::string& path, int bits) {
    return path + (bits > 1 ? "[" + std::to_string(bits - 1) + ":0]" : "");
  }
  /// The model's side of a port and the RTL's are the first two rows, the inputs of the unit come
  /// next, and the marker stands where both differ.
  void expect_difference_on_top(const std::string& file, const Wave& wave, const std::string& scope,
                                const std::string& port) {
    const Saved save = saved(file);
    const std::string model = scope + "." + port, rtl = scope + ".rtl." + port;
    const int bits = wave[model].bits;
    EXPECT_EQ(save.title, "differs: " + model);
    ASSERT_GT(save.rows.size(), 4u);
    EXPECT_EQ(save.rows[0], "+{model " + port + "} " + with_range(model, bits));
    EXPECT_EQ(save.rows[1], "+{RTL " + port + "} " + with_range(rtl, bits));
    EXPECT_THAT(save.rows[2], testing::ContainsRegex("^" + scope + "\\.[a-z0-9_]*_i"));
    EXPECT_NE(wave[model].at(save.marker), wave[rtl].at(save.marker));
    for (std::uint64_t at = wave.begin; at < save.marker; at += Period)
      ASSERT_EQ(wave[model].at(at), wave[rtl].at(at)) << at;
  }

  std::string out;
};

TEST_F(CliDifferenceTest, TheWaveformOfVerifyLiesOnTheTimeAxisOfItsFrame) {
  write_faulty_stacks();
  ASSERT_EQ(run({"verify", "stacks=mine.sv", "--frames", "3", "--random", "0", "--json"}), 1);
  const auto first = Json::parse(out)["units"][0]["first"];
  const auto place = first["place"];
  const std::uint64_t difference =
      ordinal(place["frame"].get<int>(), place["line"].get<int>(), place["clock"].get<int>());
  const Wave verified(folder / "racebeam_verify/stacks_chip.vcd");
  expect_difference_on_top("racebeam_verify/stacks_chip.gtkw", verified, "chip.u_stacks",
                           first["port"].get<std::string>());
  EXPECT_EQ(saved("racebeam_verify/stacks_chip.gtkw").marker, difference * Period);

  const auto at = [](std::uint64_t clock) {
    return place_at(static_cast<std::int64_t>(clock), LineClocks).text();
  };
  const Wave traced = trace({"--from", at(verified.begin / Period), "--to",
                             at(verified.end / Period - 1), "--use", "stacks=lockstep:mine.sv"});
  EXPECT_EQ(traced.begin, verified.begin);
  EXPECT_EQ(traced.end, verified.end);
  EXPECT_EQ(verified.begin / Period, difference < 255 ? 0 : difference - 255);
  EXPECT_EQ(verified.end / Period, difference + 1 + 64);
  int compared = 0;
  for (const auto& [path, signal] : verified.signals) {
    if (path == "chip.u_stacks.rtl.differs") continue;
    ++compared;
    EXPECT_TRUE(traced[path] == signal) << path;
  }
  EXPECT_GE(compared, 20) << "beam, inputs, and both sides of the outputs";
  EXPECT_EQ(run({"trace", "--diff", "racebeam_verify/stacks_chip.vcd", "t.vcd", "--shared"}), 0)
      << out;
}

TEST_F(CliDifferenceTest, RandomTrafficHasAnAxisOfItsOwn) {
  write_faulty_stacks();
  ASSERT_EQ(run({"verify", "stacks=mine.sv", "--frames", "0", "--random", "20000", "--json"}), 1);
  const auto first = Json::parse(out)["units"][0]["first"];
  const Wave wave(folder / "racebeam_verify/stacks_random.vcd");
  expect_difference_on_top("racebeam_verify/stacks_random.gtkw", wave, "chip.u_stacks",
                           first["port"].get<std::string>());
  const auto clock = first["clock"].get<std::uint64_t>();
  const std::uint64_t marker = saved("racebeam_verify/stacks_random.gtkw").marker;
  EXPECT_EQ(marker, clock * Period);
  EXPECT_EQ(wave["chip.clock"].number(marker), clock);
  EXPECT_EQ(wave["chip.u_stacks.rtl.differs"].at(marker), "1");
  EXPECT_EQ(wave["chip.u_stacks.rtl.differs"].at(marker - 1), "0");
}

TEST_F(CliDifferenceTest, TheTraceAroundAMismatchHasBothSidesOnTop) {
  write_faulty_stacks();
  ASSERT_EQ(run({"trace", "demo", "--use", "subdivider=lockstep,stacks=lockstep:mine.sv",
                 "--around", "mismatch", "-o", "t.vcd"}),
            1);
  const auto dot = said.find("stacks.") + 7;
  const std::string port = said.substr(dot, said.find(' ', dot) - dot);
  expect_difference_on_top("t.gtkw", Wave(folder / "t.vcd"), "chip.u_stacks", port);
}

TEST_F(CliDifferenceTest, MarksTheDifferenceAndColoursItOnlyOnATerminal) {
  write_faulty_stacks();
  const Words words = {"verify", "stacks=mine.sv", "--frames", "0", "--random", "20000"};
  const std::string red = "\x1b[1;31m>";
  ASSERT_EQ(run(words), 1);
  EXPECT_THAT(said, testing::ContainsRegex("top_[a-z0-9_]+ rtl [^\n]* >[0-9a-f]+"));
  EXPECT_THAT(said, testing::ContainsRegex("\n  sp_i +[0-9a-f]+ "));
  EXPECT_THAT(said, testing::ContainsRegex("\n  clock .* 0 .*\\+1"));
  EXPECT_THAT(said, Not(HasSubstr("\x1b")));
  Program::Setting terminal;
  terminal.terminal = true;
  ASSERT_EQ(run(words, terminal), 1);
  EXPECT_THAT(said, HasSubstr(red));
  terminal.environment = "NO_COLOR=1";
  ASSERT_EQ(run(words, terminal), 1);
  EXPECT_THAT(said, Not(HasSubstr(red)));
  EXPECT_THAT(said, HasSubstr(" >"));
}

TEST_F(CliDifferenceTest, SaysThatAnOutputComesOneClockLate) {
  write_mine("interval_fifo", "assign display_o = display[1:0];",
             "logic [1:0] late_q;\n"
             "  always_ff @(posedge clk_i) late_q <= head_only ? head_value_q : tail_value_q;\n"
             "  assign display_o = late_q;");
  // In this traffic the display changes three times in the clocks that the hint looks at.
  ASSERT_EQ(
      run({"verify", "interval_fifo=mine.sv", "--frames", "0", "--random", "20000", "--seed", "5"}),
      1);
  EXPECT_THAT(said, HasSubstr("port display_o differs on random traffic"));
  EXPECT_THAT(said, HasSubstr("hint: the RTL is one clock late: in 65 clocks from the difference "
                              "on its display_o is the model's of one clock before"));
}

}  // namespace
}  // namespace racebeam
