// An assertion that fails in a unit's RTL is told with file, line, unit and clock, and with frame
// and scan line in the chip; the command ends with 2.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <fstream>

#include "tests/cli/faulty_rtl.h"

namespace racebeam {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

class CliAssertionsTest : public testing::Test {
 protected:
  void write(const std::string& rtl) { std::ofstream(folder / "mine.sv") << rtl; }
  void run(const std::vector<std::string>& arguments) {
    Program program(folder.path(), arguments);
    code = program.wait();
    out = program.out();
    said = program.err();
  }

  ScratchFolder folder;
  int code = 0;
  std::string out, said;
};

TEST_F(CliAssertionsTest, EachKindIsToldInTheUnitAlone) {
  const std::pair<const char*, const char*> kinds[] = {
      {"assert (clocks_q != 500) else $error(\"boom %0d\", clocks_q);", ": error: boom 500"},
      {"assert (clocks_q != 500);", ": error: 'assert' failed."},
      {"assert (clocks_q != 500) else $fatal(1, \"gone\");", ": error: gone"}};
  for (const auto& [statement, message] : kinds) {
    write(faulty_stacks(statement));
    run({"verify", "stacks=mine.sv", "--frames", "0", "--random", "2000"});
    EXPECT_EQ(code, 2) << statement;
    EXPECT_THAT(said, AllOf(HasSubstr("the RTL of stacks has ended the simulation in clock 500: "
                                      "mine.sv:"),
                            HasSubstr(message)));
  }
}

TEST_F(CliAssertionsTest, PropertiesAreTold) {
  std::string rtl = faulty_stacks("");
  write(
      rtl.insert(rtl.rfind("endmodule"),
                 "  assert property (@(posedge clk_i) clocks_q != 500) else $error(\"five\");\n"));
  run({"verify", "stacks=mine.sv", "--frames", "0", "--random", "2000"});
  EXPECT_EQ(code, 2);
  EXPECT_THAT(said, AllOf(HasSubstr("in clock 500: mine.sv:"), HasSubstr(": error: five")));
}

TEST_F(CliAssertionsTest, TheChipTellsFrameLineAndClock) {
  write(faulty_stacks("assert (0) else $error(\"boom\");"));
  const char* const place = "error: boom (frame 0, line -273, clock 499";
  run({"render", "demo", "--use", "stacks=mine.sv", "--frames", "1"});
  EXPECT_EQ(code, 2);
  EXPECT_THAT(said, HasSubstr(place));
  run({"trace", "demo", "--use", "stacks=mine.sv", "--from", "0:-273", "--to", "0:-270", "-o",
       "t.vcd"});
  EXPECT_EQ(code, 2);
  EXPECT_THAT(said, HasSubstr(place));
  run({"verify", "stacks=mine.sv", "--frames", "1", "--random", "0"});
  EXPECT_EQ(code, 2);
  EXPECT_THAT(said, HasSubstr(place));
}

TEST_F(CliAssertionsTest, AssertionsThatHoldAreSilent) {
  write(faulty_stacks("assert (clocks_q == 500) else $error(\"boom\");"));
  run({"verify", "stacks=mine.sv", "--frames", "0", "--random", "2000"});
  EXPECT_EQ(code, 0) << said;
  EXPECT_THAT(said, Not(HasSubstr("boom")));
}

}  // namespace
}  // namespace racebeam
