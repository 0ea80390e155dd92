// `racebeam render --golden`: pictures of the golden tracers, and the chip compared with them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/program.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

class CliGoldenTest : public testing::Test {
 protected:
  ScratchFolder folder;
  Json parse(const std::string& name) const { return read_json(folder / name); }
};

TEST_F(CliGoldenTest, RendersWithATracerInsteadOfTheChip) {
  std::set<std::string> pictures;
  for (const std::string tracer : {"trace2", "trace3", "trace4", "geometry"}) {
    Program program(folder.path(), {"render", "demo", "--first", "9279", "--frames", "2", "--crc",
                                    "--golden", tracer, "-o", tracer, "--gif", tracer + ".gif"});
    ASSERT_EQ(program.wait(), 0) << program.err();
    EXPECT_THAT(program.out(), HasSubstr(" 9280  heights and pillars"));
    const std::string crc =
        parse(tracer + "/stats.json").at("frames")[1].at("image_crc32").get<std::string>();
    EXPECT_THAT(program.out(), testing::ContainsRegex(" [1-9][0-9]{3,}  " + crc + "\n"))
        << "intervals and checksum";
    EXPECT_THAT(program.err(), HasSubstr("wrote 2 frames in " + tracer));
    const Json stats = parse(tracer + "/stats.json");
    EXPECT_EQ(stats.at("schema"), "racebeam-golden");
    EXPECT_EQ(stats.at("tracer"), tracer);
    EXPECT_EQ(stats.at("version"), 2);
    EXPECT_EQ(stats.at("total").at("frames"), 2);
    EXPECT_EQ(stats.at("frames")[1].at("frame"), 9280);
    EXPECT_EQ(stats.at("frames")[1].count("restarts"), 0u) << "there is no chip";
    EXPECT_EQ(parse(tracer + "/manifest.json").at("level"), "golden " + tracer);
    pictures.insert(stats.at("frames")[0].at("image_crc32").get<std::string>());
  }
  EXPECT_EQ(pictures.size(), 3u) << "trace3 shows what trace2 shows";
}

TEST_F(CliGoldenTest, TellsWhatRaysCostOneByOne) {
  Json totals[2];
  for (const int clocked : {0, 1}) {
    const std::string tracer = clocked ? "trace3" : "trace2";
    Program program(folder.path(), {"render", "demo", "--first", "7167", "--frames", "2", "--jobs",
                                    "2", "--golden", tracer, "--stats", tracer + ".json"});
    ASSERT_EQ(program.wait(), 0) << program.err();
    const Json total = totals[clocked] = parse(tracer + ".json").at("total");
    EXPECT_EQ(total.at("rays"), 2 * 640 * 480);
    EXPECT_EQ(total.at("crossing_decisions"), 6 * total.at("rooms_entered").get<int>());
    EXPECT_EQ(total.at("solid_decisions"), 2 * total.at("solid_hits").get<int>());
    EXPECT_THAT(program.out(), HasSubstr(" a ray, 6.00 a room crossed, 2.00 at a solid wall\n"));
    EXPECT_THAT(program.out(),
                testing::ContainsRegex("total  2 frames +" + total.at("decisions").dump() + " +" +
                                       total.at("rooms_entered").dump()));
  }
  EXPECT_EQ(totals[0].at("decisions"), totals[1].at("decisions"));
  EXPECT_EQ(totals[0].count("clocks"), 0u);
  const Json& lines = totals[1].at("line_clocks");
  EXPECT_EQ(lines.at("sum"), totals[1].at("clocks"));
  EXPECT_GT(lines.at("min"), 1600) << "no line is in time";
}

TEST_F(CliGoldenTest, TellsHowOftenEdgesSwitch) {
  Program program(folder.path(),
                  {"render", "demo", "--first", "9500", "--golden", "trace4", "--stats", "a.json"});
  ASSERT_EQ(program.wait(), 0) << program.err();
  const Json total = parse("a.json").at("total");
  const Json& switches = total.at("switches");
  EXPECT_EQ(switches.size(), 17u);
  EXPECT_GT(switches[1], 0);
  int edges = 0;
  for (std::size_t n = 1; n < switches.size(); ++n) edges += switches[n].get<int>();
  EXPECT_EQ(total.at("edges"), edges);
  EXPECT_EQ(total.at("chattering_edges"), edges - switches[1].get<int>());
  EXPECT_THAT(program.out(), HasSubstr("edges that switch more than once along a line: " +
                                       total.at("chattering_edges").dump() + " of " +
                                       total.at("edges").dump() + ", "));
}

TEST_F(CliGoldenTest, ComparesTheChipAndSaysWhy) {
  Program program(folder.path(), {"render", "demo", "--first", "9279", "--frames", "2", "--every",
                                  "300", "--golden", "compare", "-o", "o"});
  ASSERT_EQ(program.wait(), 0) << program.err();
  EXPECT_THAT(program.out(), HasSubstr("not as trace4"));
  const Json stats = parse("o/stats.json");
  EXPECT_EQ(stats.at("schema"), "racebeam-stats");
  int sum = 0;
  for (const Json& frame : stats.at("frames").elements()) {
    const Json& golden = frame.at("golden");
    EXPECT_GT(golden.at("differing_pixels").at("trace4"), 0);
    EXPECT_EQ(golden.at("causes").at("unexplained"), 0);
    sum += golden.at("differing_pixels").at("trace4").get<int>();
  }
  EXPECT_EQ(stats.at("total").at("golden").at("differing_pixels").at("trace4"), sum);
  EXPECT_THAT(program.out(), HasSubstr(" " + std::to_string(sum) + "\n"));
  const Json total = stats.at("total").at("golden");
  for (const auto& [tracer, colour] :
       {std::pair{"trace4", "yellow"}, {"trace2", "cyan"}, {"geometry", "magenta"}})
    EXPECT_THAT(program.out(),
                testing::ContainsRegex(std::string(tracer) + " +" +
                                       total.at("differing_pixels").at(tracer).dump() +
                                       "  in difference_NNNN.png " + colour));
  for (const auto& [cause, pixels] : total.at("causes").items())
    if (pixels > 0) {
      EXPECT_THAT(program.out(),
                  testing::ContainsRegex("  " + cause + " +" + pixels.dump() + "  "));
    }
  for (const char* name : {"difference_9279.png", "difference_9579.png"}) {
    EXPECT_EQ(read_file(folder / ("o/" + std::string(name))).substr(1, 3), "PNG");
    EXPECT_THAT(parse("o/manifest.json").at("files").elements(), testing::Contains(name));
  }
}

TEST_F(CliGoldenTest, WithoutItNothingIsCompared) {
  Program program(folder.path(), {"render", "demo", "--json", "--stats", "a.json"});
  ASSERT_EQ(program.wait(), 0) << program.err();
  EXPECT_EQ(program.json().at("frames")[0].count("golden"), 0u);
  EXPECT_EQ(program.json().at("total").count("golden"), 0u);
}

TEST_F(CliGoldenTest, RefusesWhatItCannotDo) {
  const auto expect_refused = [&](std::vector<std::string> words, const std::string& why) {
    words.insert(words.begin(), {"render", "demo"});
    Program program(folder.path(), words);
    EXPECT_EQ(program.wait(), 2);
    EXPECT_THAT(program.err(), HasSubstr(why));
    EXPECT_TRUE(fs::is_empty(folder.path()));
  };
  expect_refused({"--golden", "trace5"}, "unknown golden tracer 'trace5'");
  expect_refused({"--golden", "comprae"}, "did you mean 'compare'?");
  expect_refused({"--golden"}, "--golden");
  expect_refused({"--golden", ""}, "an empty name");
  expect_refused({"--golden", "trace4", "--wav", "a.wav"}, "--wav needs the chip");
}

}  // namespace
}  // namespace racebeam
