// `racebeam signoff` keeps what it has found: whole after a kill, and asked again where it has to
// be.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include "tests/cli/program.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using Words = std::vector<std::string>;
namespace fs = std::filesystem;

class CliSignoffKeptTest : public testing::Test {
 protected:
  static Words words(const std::string& random) {
    return {"signoff", "stacks", "--only", "mutants", "--mutants", "16", "--random", random};
  }
  /// The detail of a green run with so many clocks of random traffic.
  Json detail(const std::string& random) {
    Words all = words(random);
    all.push_back("--json");
    Program run(folder.path(), all);
    EXPECT_EQ(run.wait(), 0) << run.err() << run.out();
    return run.json()["results"][0]["detail"];
  }
  std::string fates() const { return folder / "racebeam_signoff/stacks.mutants"; }

  ScratchFolder folder;
};

TEST_F(CliSignoffKeptTest, ARunThatWasKilledGoesOnBehindItsLastMutant) {
  const Json whole = detail("5000");
  const std::string file = fates();
  const std::string text = read_file(file);
  const auto cut = text.find('\n', text.size() / 2) + 10;  // in the midst of a line
  std::ofstream(file) << text.substr(0, cut);
  EXPECT_EQ(detail("5000"), whole);
  // What is there is taken as it is, and not found again.
  const std::string all = read_file(file), before = "\"clock\":";
  const auto clock = all.find(before, all.find("\"found\"")) + before.size();
  std::ofstream(file) << all.substr(0, clock) << "4444" << all.substr(all.find(',', clock));
  EXPECT_EQ(detail("5000")["clocks"]["most"], 4444);
  EXPECT_EQ(detail("4999")["clocks"], whole["clocks"]) << "other traffic";
}

TEST_F(CliSignoffKeptTest, WhatWasAskedWithOtherAssertionsIsAskedAgain) {
  const Json whole = detail("5000");
  std::string text = read_file(fates());
  const std::string equal = R"("state":"equal","stream":"","clock":0)",
                    undecided = R"("state":"undecided","stream":"others","clock":999)";
  ASSERT_NE(text.find(equal), std::string::npos);
  std::ofstream(fates()) << text.replace(text.find(equal), equal.size(), undecided);
  EXPECT_EQ(detail("5000"), whole);
}

TEST_F(CliSignoffKeptTest, AProofInTheTreeIsTakenWithoutAsking) {
  Words all = words("5000");
  for (const char* word : {"--json", "--prove", "0"}) all.emplace_back(word);
  const auto detail_of = [&](int code) {
    Program run(folder.path(), all);
    EXPECT_EQ(run.wait(), code) << run.err() << run.out();
    return run.json()["results"][0]["detail"];
  };
  const Json kept = detail_of(0);
  EXPECT_GT(kept["equal"].get<int>(), 0);
  EXPECT_EQ(kept["kept_proofs"], kept["equal"]);
  EXPECT_EQ(read_file(folder / "racebeam_signoff/stacks.proved"),
            read_file(RACEBEAM_SOURCE_DIR "/tb/signoff/proved/beam/stacks.proved"));
  all.emplace_back("--prove-again");
  const Json again = detail_of(1);
  EXPECT_EQ(again["kept_proofs"], 0);
  EXPECT_EQ(again["undecided"], kept["equal"]);
}

std::string circuit_line(const std::string& file) {
  const std::string text = read_file(file), begin = "\ncircuit ";
  const auto at = text.find(begin);
  return at == std::string::npos ? "" : text.substr(at, text.find('\n', at + 1) - at);
}

class LongKeptProofsTest : public testing::Test {};

// Units with a table have proofs of those of a scene, see docs/signoff.md.
TEST_F(LongKeptProofsTest, AreOfTheCircuitsThatOurUnitsHaveToday) {
  const std::string source = RACEBEAM_SOURCE_DIR;
  int files = 0;
  for (const auto& file : fs::recursive_directory_iterator(source + "/tb/signoff/proved")) {
    if (!file.is_regular_file()) continue;
    ++files;
    const std::string unit = file.path().stem(), kept = circuit_line(file.path());
    std::string today;
    for (const std::string& scene : {std::string("demo"), source + "/tests/signoff/tables.toml",
                                     source + "/tests/museum/sphere.toml"}) {
      const ScratchFolder folder;
      Program run(folder.path(),
                  {"signoff", unit, "--engine", file.path().parent_path().filename(), "--scene",
                   scene, "--only", "mutants", "--mutants", "1", "--random", "10", "--prove", "0"});
      run.wait();
      const std::string written = folder / ("racebeam_signoff/" + unit + ".proved");
      today = fs::exists(written) ? circuit_line(written) : "none";
      if (today == kept) break;
    }
    EXPECT_EQ(today, kept) << file.path() << ": racebeam signoff " << unit << " writes it anew";
  }
  EXPECT_GT(files, 0);
}

TEST_F(CliSignoffKeptTest, AnInterruptEndsItAtOnceAndLeavesNobody) {
  Program run(folder.path(), words("500000000"));
  for (int n = 0; n < 6000 && !(fs::exists(folder / "racebeam_signoff") && run.children() > 0); ++n)
    usleep(10'000);
  run.signal(SIGTERM);
  EXPECT_EQ(run.wait(), 130) << run.err();
  EXPECT_EQ(run.children(), 0);
  EXPECT_THAT(run.err(), HasSubstr("the same command goes on"));
}

}  // namespace
}  // namespace racebeam
