// RTL that ends the simulation, does not settle, does not return, crashes or prints without end:
// every command says which unit did what and where, ends with 2 and leaves no process.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <filesystem>

#include "tests/cli/faulty_rtl.h"
#include "tests/cli/racebeam_processes.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using testing::Not;
using Words = std::vector<std::string>;
namespace fs = std::filesystem;

struct Fault {
  const char* name;
  const char* statement;          ///< in clock 500; empty: a loop without a register
  std::vector<const char*> said;  ///< parts of the message
};
void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

class RtlFaultsBench : public testing::Test {
 protected:
  RtlFaultsBench() {
    setenv("RACEBEAM_RTL_SECONDS", "0.5", 1);
    setenv("SDL_VIDEODRIVER", "dummy", 1);
    setenv("SDL_AUDIODRIVER", "dummy", 1);
  }
  void write(const std::string& rtl) { std::ofstream(folder / "mine.sv") << rtl; }
  /// Runs the program to its end, after which no process of it lives.
  void run(const std::vector<std::string>& arguments) {
    const MarkedProcesses own;
    Program::Setting setting;
    setting.environment = own.mark();
    Program program(folder.path(), arguments, setting);
    code = program.wait();
    out = program.out();
    said = program.err();
    EXPECT_TRUE(own.become(0)) << own.count() << " processes are left";
  }

  ScratchFolder folder;
  int code = 0;
  std::string out, said;
};

class CliRtlFaultsTest : public RtlFaultsBench, public testing::WithParamInterface<Fault> {
 protected:
  CliRtlFaultsTest() {
    const std::string fault = GetParam().statement;
    write(fault.empty() ? circular_stacks() : faulty_stacks(fault));
  }
  void expect_told(const std::string& in) {
    EXPECT_EQ(code, 2) << in;
    EXPECT_THAT(said, Not(HasSubstr("internal error"))) << in;
    for (const char* part : GetParam().said) EXPECT_THAT(said, HasSubstr(part)) << in;
  }
};

TEST_P(CliRtlFaultsTest, VerifyTellsItInTheRowOfTheUnit) {
  run({"verify", "ray_stepper", "stacks=mine.sv", "--frames", "1", "--random", "2000", "--json"});
  expect_told("random");
  const auto units = Json::parse(out)["units"];
  ASSERT_EQ(units.size(), 3u) << "the chip goes on without the unit";
  for (const auto& unit : units.elements()) {
    if (unit["unit"] == "ray_stepper") {
      EXPECT_TRUE(unit["fault"].is_null());
      EXPECT_EQ(unit["differences"], 0);
      continue;
    }
    EXPECT_NEAR(unit["clocks"].get<int>(), 500, 1) << "that whose edge ends the RTL is none";
    for (const char* part : GetParam().said)
      EXPECT_THAT(unit["fault"].get<std::string>(), HasSubstr(part));
  }
  run({"verify", "ray_stepper", "stacks=mine.sv", "--frames", "1", "--random", "0"});
  expect_told("chip");
  EXPECT_THAT(out, testing::ContainsRegex("\nray_stepper +chip +840001 "));
  EXPECT_THAT(out, testing::ContainsRegex("\nstacks +chip +(499|50[01]) .* the RTL of stacks "));
}

TEST_P(CliRtlFaultsTest, RenderTellsIt) {
  for (const char* jobs : {"1", "2"}) {
    run({"render", "demo", "--use", "stacks=mine.sv", "--frames", "20", "--jobs", jobs, "--json"});
    expect_told(jobs);
    EXPECT_EQ(out, "");
  }
}

TEST_P(CliRtlFaultsTest, TraceTellsItAndKeepsTheLastLines) {
  run({"trace", "demo", "--use", "stacks=mine.sv", "--from", "0:-273", "--to", "0:-270", "-o",
       "t.vcd"});
  expect_told("window");
  EXPECT_FALSE(fs::exists(folder / "t.vcd"));
  run({"trace", "demo", "--use", "stacks=mine.sv", "--record", "1", "--from", "0:-273", "--to",
       "0:-270", "-o", "t.vcd"});
  expect_told("record");
  EXPECT_TRUE(fs::exists(folder / "t.vcd")) << said;
}

TEST_P(CliRtlFaultsTest, ViewTellsIt) {
  run({"view", "demo", "--use", "stacks=mine.sv", "--term", "--frames", "2"});
  expect_told("terminal");
#ifdef RACEBEAM_WINDOW
  run({"view", "demo", "--use", "stacks=mine.sv", "--frames", "2"});
  expect_told("window");
#endif
}

const char* const Ends = "the RTL of stacks has ended the simulation in clock 500: mine.sv:";

INSTANTIATE_TEST_SUITE_P(
    Kinds, CliRtlFaultsTest,
    testing::Values(
        Fault{"Finish", "$finish;", {Ends, ": $finish"}},
        Fault{"Fatal", "$fatal(1, \"boom\");", {Ends, ": error: boom"}},
        Fault{"Loop", "", {"the RTL of stacks", "does not settle", ": mine.sv:", "stacks.swing"}},
        Fault{"Hang",
              "while (clocks_q == 500) $c(\"\");",
              {"the RTL of stacks does not return from clock 500", "RACEBEAM_RTL_SECONDS"}},
        Fault{"Crash",
              "$c(\"*(volatile int*)8 = 1;\");",
              {"the RTL of stacks", "crashed in clock 500: Segmentation fault"}}),
    [](const auto& fault) { return fault.param.name; });

class CliRtlEndsTest : public RtlFaultsBench {};

TEST_F(CliRtlEndsTest, StopErrorAndExceptionsAreToldApart) {
  const std::vector<Fault> faults = {
      {"", "$stop;", {Ends, ": $stop"}},
      {"", "$error(\"count %0d\", clocks_q);", {Ends, ": error: count 500"}},
      {"", "$c(\"throw std::runtime_error(\\\"no more\\\");\");", {"in clock 500: no more"}},
      {"", "$c(\"throw 7;\");", {"in clock 500: an exception of no known type"}},
      {"", "$c(\"abort();\");", {"crashed in clock 500: Aborted"}},
      {"", "$c(\"volatile int z = 0; z = 7 / z;\");", {"in clock 500: Floating point exception"}}};
  for (const Fault& fault : faults) {
    write(faulty_stacks(fault.statement));
    run({"verify", "stacks=mine.sv", "--frames", "0", "--random", "2000"});
    EXPECT_EQ(code, 2);
    for (const char* part : fault.said) EXPECT_THAT(said, HasSubstr(part));
  }
}

// What has left the heap locked or broken may say no more than that.
TEST_F(CliRtlEndsTest, HangsAndCrashesInsideTheHeapAreTold) {
  std::vector<Fault> faults = {
      {"",
       "while (clocks_q == 500) $c(\"static void* volatile p; p = malloc(5000); free(p);\");",
       {"the RTL of stacks", "does not return from clock 500"}}};
#ifndef __SANITIZE_ADDRESS__  // which tells of the broken heap itself, and ends the program
  faults.push_back(
      {"",
       "$c(\"volatile char* p = (char*)malloc(64); for (int i = -64; i < 9999; ++i) p[i] = 7; "
       "free((void*)p);\");",
       {"the RTL of stacks", "crashed in clock 500"}});
#endif
  for (const Fault& fault : faults) {
    write(faulty_stacks(fault.statement));
    for (const Words& words :
         {Words{"verify", "stacks=mine.sv", "--frames", "0", "--random", "2000"},
          Words{"render", "demo", "--use", "stacks=mine.sv", "--frames", "2", "--jobs", "2"}}) {
      run(words);
      EXPECT_EQ(code, 2) << words[0];
      EXPECT_THAT(said, Not(HasSubstr("internal error"))) << words[0];
      for (const char* part : fault.said) EXPECT_THAT(said, HasSubstr(part)) << words[0];
    }
  }
}

TEST_F(CliRtlEndsTest, ErrorsOfElaborationAreTold) {
  for (const std::string task : {"$error(", "$fatal(1, "}) {
    std::string rtl = faulty_stacks("");
    write(
        rtl.insert(rtl.find("endmodule"), "if (IntervalStackDepth > 1) " + task + "\"deep\");\n"));
    run({"verify", "stacks=mine.sv", "--frames", "0"});
    EXPECT_EQ(code, 2) << task;
    EXPECT_THAT(said, HasSubstr("cannot be verilated"));
    EXPECT_THAT(said, HasSubstr("deep"));
  }
}

TEST_F(CliRtlEndsTest, RegistersOnTheFallingEdgeAreAWarning) {
  std::string rtl = faulty_stacks("");
  write(rtl.insert(rtl.find("endmodule"),
                   "  logic half_q;\n  always_ff @(negedge clk_i) half_q <= push_en_i;\n"));
  run({"verify", "stacks=mine.sv", "--frames", "0", "--random", "1000"});
  EXPECT_EQ(code, 0);
  EXPECT_THAT(said, testing::ContainsRegex("warning: mine.sv:[0-9]+ half_q changes on the falling "
                                           "edge of the clock; half a clock is not the contract"));
  run({"verify", "stacks", "--frames", "0", "--random", "1000"});
  EXPECT_THAT(said, Not(HasSubstr("falling edge")));
}

TEST_F(CliRtlEndsTest, WhatRtlPrintsGoesToStderr) {
  write(
      faulty_stacks("$display(\"hello %0d\", clocks_q); $write(\"and\");"
                    "$fdisplay(32'h8000_0001, \"a handle\"); $c(\"printf(\\\"in C\\\\n\\\");\");"));
  run({"verify", "stacks=mine.sv", "--frames", "1", "--random", "1000", "--json"});
  EXPECT_EQ(code, 0) << said;
  EXPECT_EQ(Json::parse(out)["units"].size(), 2u);
  for (const char* words : {"hello 500\n", "and", "a handle", "in C\n"})
    EXPECT_THAT(said, HasSubstr(words));
}

TEST_F(CliRtlEndsTest, MoreThanTenMegabytesAreTooMuch) {
  write(faulty_stacks("for (int n = 0; n < 100000; n++) $display(\"line %0200d\", n);"));
  run({"render", "demo", "--use", "stacks=mine.sv", "--frames", "2", "--json"});
  EXPECT_EQ(code, 2);
  EXPECT_EQ(out, "");
  EXPECT_LT(said.size(), 10'100'000u);
  EXPECT_THAT(said.substr(said.size() - 400),
              HasSubstr("in clock 500: it printed more than 10 MB; the last line: line 0000"));
}

// Frames before the fault are kept, with what tells about them.
TEST_F(CliRtlEndsTest, RenderKeepsTheFramesBefore) {
  std::string rtl = faulty_stacks("$finish;");
  rtl.replace(rtl.find("clocks_q == 500"), 15, "clocks_q == 900000");
  write(rtl);
  for (const char* jobs : {"1", "2"}) {
    const std::string to = std::string("out") + jobs;
    run({"render", "demo", "--use", "stacks=mine.sv", "--frames", "12", "--jobs", jobs, "-o", to});
    EXPECT_EQ(code, 2);
    EXPECT_THAT(said, HasSubstr("stopped early; kept 1 frame in " + to));
    EXPECT_THAT(said, HasSubstr("in clock 900000: mine.sv:"));
    const auto manifest = read_json(folder / (to + "/manifest.json"));
    EXPECT_EQ(manifest["frames_rendered"], 1);
  }
}

}  // namespace
}  // namespace racebeam
