// `racebeam render --golden`: pictures of the golden tracers, and the chip compared with them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/program.h"

namespace racebeam {
namespace {

using nlohmann::json;
using testing::HasSubstr;
namespace fs = std::filesystem;

class CliGoldenTest : public testing::Test {
 protected:
  ScratchFolder folder;
  json parse(const std::string& name) const { return json::parse(read_file(folder / name)); }
};

TEST_F(CliGoldenTest, RendersWithATracerInsteadOfTheChip) {
  std::set<std::string> pictures;
  for (const std::string tracer : {"trace2", "trace4", "geometry"}) {
    Program program(folder.path(), {"render", "demo", "--first", "9279", "--frames", "2", "--crc",
                                    "--golden", tracer, "-o", tracer, "--gif", tracer + ".gif"});
    ASSERT_EQ(program.wait(), 0) << program.err();
    EXPECT_THAT(program.out(), HasSubstr(" 9280  heights and pillars"));
    const std::string crc =
        parse(tracer + "/stats.json").at("frames")[1].at("image_crc32").get<std::string>();
    EXPECT_THAT(program.out(), testing::ContainsRegex(" [1-9][0-9]{3,}  " + crc + "\n"))
        << "intervals and checksum";
    EXPECT_THAT(program.err(), HasSubstr("wrote 2 frames in " + tracer));
    const json stats = parse(tracer + "/stats.json");
    EXPECT_EQ(stats.at("schema"), "racebeam-golden");
    EXPECT_EQ(stats.at("tracer"), tracer);
    EXPECT_EQ(stats.at("total"), (json{{"frames", 2}}));
    EXPECT_EQ(stats.at("frames")[1].at("frame"), 9280);
    EXPECT_EQ(stats.at("frames")[1].count("decisions"), 0u) << "there is no chip";
    EXPECT_EQ(parse(tracer + "/manifest.json").at("level"), "golden " + tracer);
    pictures.insert(stats.at("frames")[0].at("image_crc32").get<std::string>());
  }
  EXPECT_EQ(pictures.size(), 3u) << "each tracer has its own picture";
}

TEST_F(CliGoldenTest, ComparesTheChipAndSaysWhy) {
  Program program(folder.path(), {"render", "demo", "--first", "9279", "--frames", "2", "--every",
                                  "300", "--golden", "compare", "-o", "o"});
  ASSERT_EQ(program.wait(), 0) << program.err();
  EXPECT_THAT(program.out(), HasSubstr("not as trace4"));
  const json stats = parse("o/stats.json");
  EXPECT_EQ(stats.at("schema"), "racebeam-stats");
  int sum = 0;
  for (const json& frame : stats.at("frames")) {
    const json& golden = frame.at("golden");
    EXPECT_GT(golden.at("differing_pixels").at("trace4"), 0);
    EXPECT_EQ(golden.at("causes").at("unexplained"), 0);
    sum += golden.at("differing_pixels").at("trace4").get<int>();
  }
  EXPECT_EQ(stats.at("total").at("golden").at("differing_pixels").at("trace4"), sum);
  EXPECT_THAT(program.out(), HasSubstr(" " + std::to_string(sum) + "\n"));
  const json total = stats.at("total").at("golden");
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
    EXPECT_THAT(parse("o/manifest.json").at("files"), testing::Contains(name));
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
  expect_refused({"--golden", "trace3"}, "unknown golden tracer 'trace3'");
  expect_refused({"--golden", "comprae"}, "did you mean 'compare'?");
  expect_refused({"--golden"}, "--golden");
  expect_refused({"--golden", ""}, "an empty name");
  expect_refused({"--golden", "trace4", "--wav", "a.wav"}, "--wav needs the chip");
}

}  // namespace
}  // namespace racebeam
