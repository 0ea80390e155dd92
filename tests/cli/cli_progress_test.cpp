// Progress bars of the program: on a terminal, and nowhere else.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "tests/cli/program.h"

namespace racebeam {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using Words = std::vector<std::string>;

struct Command {
  const char* name;
  Words words;
  const char* bar;  // a part of it
};
void PrintTo(const Command& command, std::ostream* out) { *out << command.name; }

class CliProgressTest : public testing::TestWithParam<Command> {
 protected:
  /// What the command says on stderr.
  std::string said(bool terminal, const std::string& environment = {}) {
    const ScratchFolder folder;
    Program::Setting setting;
    setting.terminal = terminal;
    setting.environment = environment;
    Program program(folder.path(), GetParam().words, setting);
    const int code = program.wait();
    EXPECT_EQ(code, 0) << program.err();
    return program.err();
  }
};

TEST_P(CliProgressTest, ABarIsDrawnOnATerminalAndWipedInTheEnd) {
  const std::string text = said(true, "CI=");
  EXPECT_THAT(text, ContainsRegex("\\[#*\\.*\\] [0-9]+/" + std::string(GetParam().bar)));
  const auto bar = text.rfind("\r\x1b[K[");
  ASSERT_NE(bar, std::string::npos);
  EXPECT_NE(text.find("\r\x1b[K", bar + 1), std::string::npos) << "the bar stays";
}

TEST_P(CliProgressTest, NothingIsDrawnWhereNobodyWatches) {
  for (const char* environment : {"CI=1", "CI=true", "TERM=dumb"}) {
    const std::string text = said(true, environment);
    EXPECT_THAT(text, Not(HasSubstr("\x1b"))) << environment;
    EXPECT_THAT(text, Not(HasSubstr("[."))) << environment;
  }
  EXPECT_THAT(said(false), Not(HasSubstr("\x1b")));
}

const Command commands[] = {
    {"Trace", {"trace", "demo", "--from", "60:-270", "--to", "60:-268", "-o", "t.vcd"}, "6 lines"},
    {"TraceOfTransactions",
     {"trace", "demo", "--level", "tlm", "--from", "60:0", "--to", "62:0", "-o", "t.vcd"},
     "3 frames"},
    {"TraceThatLooksForSomething",
     {"trace", "demo", "--when", "line == -200", "--from", "60:-270", "--pre", "3", "-o", "t.vcd"},
     "525 lines"},
    {"TraceAroundWhatTheCoresFind",
     {"trace", "demo", "--around", "first-restart", "--from", "7223:-273", "--lines", "0", "-o",
      "t.vcd"},
     "525 lines"},
    {"RandomTraffic",
     {"verify", "stacks", "camera_unit", "--frames", "0", "--random", "20000"},
     "40000 clocks of units alone"},
    {"Verify", {"verify", "stacks", "--frames", "1", "--random", "0"}, "1 frames"},
    {"Render", {"render", "demo", "--frames", "2", "--stats", "s.json"}, "2 frames"},
    {"Bench", {"bench", "vga_timing", "--repeat", "1"}, "1 rows"},
};

INSTANTIATE_TEST_SUITE_P(Commands, CliProgressTest, testing::ValuesIn(commands),
                         [](const auto& command) { return std::string(command.param.name); });

}  // namespace
}  // namespace racebeam
