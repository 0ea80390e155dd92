// The file of a stream: what is written is read, and what is wrong is named with its line.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/port_stream.h"

#include <gmock/gmock.h>

#include <fstream>
#include <random>

#include "tb/base/errors.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {
namespace {

using testing::HasSubstr;

/// A unit with a reset, inputs of 8 and of 64 bits, and one whose least value is 1.
PortStream form(bool counts_frames = false) {
  PortStream stream;
  stream.unit = "made";
  stream.counts_frames = counts_frames;
  stream.inputs = {
      {"rst_ni", 1, 0, 1}, {"a_i", 8, -1, 0}, {"wide_i", 64, -1, 0}, {"step_i", 4, -1, 1}};
  return stream;
}

class PortStreamTest : public testing::Test {
 protected:
  PortStream read(const std::string& text, const PortStream& of = form()) {
    std::ofstream(folder / "a.stream") << text;
    return read_stream(folder / "a.stream", of);
  }
  /// What is said of a file with these lines behind a head of three.
  std::string refusal(const std::string& lines) {
    try {
      read("# racebeam-stream 1\n# why\nunit made\n" + lines);
    } catch (const UsageError& error) {
      const std::string path = folder / "a.stream", said = error.what();
      EXPECT_EQ(said.substr(0, path.size()), path);
      return said.substr(path.size());
    }
    ADD_FAILURE() << "it was taken";
    return "";
  }

  ScratchFolder folder;
};

TEST_F(PortStreamTest, WhatIsWrittenIsRead) {
  std::mt19937_64 random(3);
  for (int round = 0; round < 50; ++round) {
    PortStream stream = form(true);
    const std::uint64_t clocks = 2 + random() % 20;
    for (std::uint64_t clock = 0; clock < clocks; ++clock)
      for (const PortStream::Input& input : stream.inputs)
        stream.values.push_back(round % 2 == 0 && clock > 1 && random() % 2
                                    ? stream.at(clock - 1, stream.values.size() % 4)
                                    : raw_bits(random(), input.bits));
    if (round % 3 == 0)
      stream.seeks[1 + random() % (clocks - 1)] = static_cast<int>(random() % 9999);
    stream.begin_in_reset();
    const PortStream again = read(stream_text(stream, {"of a test", "in two lines"}), form(true));
    ASSERT_EQ(again.values, stream.values);
    ASSERT_EQ(again.seeks, stream.seeks);
  }
}

TEST_F(PortStreamTest, OnlyWhatMovesHasAColumnAndEqualClocksOneLine) {
  PortStream stream = form();
  stream.values = {0, 0, 0, 1, 1, 5, 7, 1, 1, 5, 8, 1, 1, 5, 8, 1};
  EXPECT_EQ(stream_text(stream, {"why"}),
            "# racebeam-stream 1\n# why\nunit made\nhold a_i 5\nclock     wide_i\n"
            "1              7\n2..3           8\n");
  EXPECT_EQ(stream.moving(), 1u);
}

TEST_F(PortStreamTest, AFileMayBeWrittenByHand) {
  const PortStream stream =
      read("# racebeam-stream 1\r\n\n  unit made # ours\nclock a_i\n1 0x1F # first\n2..3 0\n");
  EXPECT_EQ(stream.clocks(), 4u);
  EXPECT_EQ(stream.values, (std::vector<std::uint64_t>{0, 0, 0, 1, 1, 0x1f, 0, 1,  //
                                                       1, 0, 0, 1, 1, 0, 0, 1}));
}

TEST_F(PortStreamTest, ClocksThatAreLeftOutTakeTheirFrameAlong) {
  PortStream stream = form(true);
  for (std::uint64_t value = 0; value < 24; ++value) stream.values.push_back(value);
  stream.seeks = {{1, 10}, {2, 20}, {4, 40}};
  const PortStream less = stream.without(1, 4);
  EXPECT_EQ(less.clocks(), 3u);
  EXPECT_EQ(less.at(1, 0), 16u);
  EXPECT_EQ(less.seeks, (std::map<std::uint64_t, int>{{1, 40}}));
  EXPECT_EQ(stream.without(1, 3).seeks, (std::map<std::uint64_t, int>{{1, 20}, {2, 40}}));
}

TEST_F(PortStreamTest, EpisodesEachBeginInResetWithInputsAtRest) {
  PortStream first = form(), second = form();
  first.values = {0, 0, 0, 1, 1, 5, 7, 1};
  second.values = {0, 0, 0, 1, 1, 0, 9, 1, 1, 1, 9, 1};
  const std::string text =
      stream_head("made", {"of a test"}) + episode_text(first, "one") + episode_text(second, "two");
  EXPECT_EQ(read(text).values, (std::vector<std::uint64_t>{0, 0, 0, 1, 1, 5, 7, 1,  //
                                                           0, 0, 0, 1, 1, 0, 9, 1, 1, 1, 9, 1}));
  const auto episodes = read_episodes(folder / "a.stream", form());
  ASSERT_EQ(episodes.size(), 2u);
  EXPECT_EQ(episodes[0].values, first.values);
  EXPECT_EQ(episodes[1].values, second.values);
}

TEST_F(PortStreamTest, AFrameStaysInItsEpisode) {
  const PortStream stream =
      read("# racebeam-stream 1\nunit made\nclock\n1..2\nepisode\nclock\nframe 7\n1\n", form(true));
  EXPECT_EQ(stream.seeks, (std::map<std::uint64_t, int>{{4, 7}}));
}

TEST_F(PortStreamTest, BadLinesAreNamedWithWhatToDo) {
  EXPECT_EQ(refusal("unit other\n"), ":4: a second unit; a stream is for one");
  EXPECT_EQ(refusal("hold a_i\n"), ":4: hold takes an input and its value, as in 'hold NAME 1f'");
  EXPECT_THAT(refusal("hold a_o 1\n"), HasSubstr(":4: unknown input of made 'a_o'; did you mean"));
  EXPECT_EQ(refusal("hold a_i 100\n"),
            ":4: 100 does not fit a_i, which has 8 bits; ff is the "
            "largest value");
  EXPECT_EQ(refusal("hold a_i 1g\n"), ":4: '1g' is not a hexadecimal number");
  EXPECT_THAT(refusal("1 0\n"), HasSubstr(":4: '1' is not known here; the line 'clock NAME ...'"));
  EXPECT_EQ(refusal("clock a_i\n2 0\n"),
            ":5: '2' stands where clock 1 must; clocks are numbered from 1 on");
  EXPECT_THAT(refusal("clock a_i\n1 0\n3 0\n"), HasSubstr(":6: '3' stands where clock 2 must"));
  EXPECT_THAT(refusal("clock a_i\n1 0\n2..1 0\n"), HasSubstr(":6: '2..1' stands where clock 2"));
  EXPECT_THAT(refusal("clock a_i\n1..9999999999 0\n"), HasSubstr(":5: a stream has 1000000"));
  EXPECT_THAT(refusal("clock a_i\n1\n"), HasSubstr(":5: 0 values for 1 inputs; give one for each"));
  EXPECT_THAT(refusal("clock a_i\nhold a_i 1\n"), HasSubstr(":5: hold stands before the line"));
  EXPECT_THAT(refusal("clock a_i\nclock a_i\n"), HasSubstr(":5: a second line 'clock'"));
  EXPECT_THAT(refusal("clock\nfram 3\n"), HasSubstr(":5: 'fram' is not the number of a clock"));
  EXPECT_EQ(refusal("frame 3\n"), ":4: made counts no frames; remove this line");
  EXPECT_THAT(refusal("clock a_i\n"), HasSubstr("there is no clock; add a line such as '1'"));
  EXPECT_EQ(refusal("episode 1\n"), ":4: episode stands alone");
  EXPECT_THAT(refusal("clock\n1\nepisode\n"), HasSubstr("there is no clock; add a line"));
  EXPECT_THAT(refusal("clock\n1\nepisode\nepisode\n"), HasSubstr(":7: there is no clock"));
}

TEST_F(PortStreamTest, FilesThatAreNoStreamAreNamed) {
  EXPECT_THROW(read_stream(folder / "none", form()), UsageError);
  EXPECT_THROW(read_stream(folder.path(), form()), UsageError);
  EXPECT_THROW(read(""), UsageError);
  EXPECT_THROW(read("# racebeam-stream 2\nunit made\nclock\n1\n"), UsageError);
  EXPECT_THROW(read("# racebeam-stream 1\n"), UsageError);
  EXPECT_THROW(read("# racebeam-stream 1\nunit other\nclock\n1\n"), UsageError);
  EXPECT_EQ(read("# racebeam-stream 1\nunit made\nclock\n1\n").clocks(), 2u) << "that is one";
  EXPECT_EQ(unit_of_stream(folder / "a.stream"), "made");
}

}  // namespace
}  // namespace racebeam
