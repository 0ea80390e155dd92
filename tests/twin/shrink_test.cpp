// Promises of tb/twin/shrink.h, of differences that are known by construction.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/shrink.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

namespace racebeam {
namespace {

/// A unit with the inputs rst_ni, a_i and b_i of 8 bits, and step_i, whose least value is 1.
enum : std::size_t { Reset, A, B, Step };
PortStream form() {
  PortStream stream;
  stream.unit = "made";
  stream.counts_frames = true;
  stream.inputs = {{"rst_ni", 1, 0, 1}, {"a_i", 8, -1, 0}, {"b_i", 8, -1, 0}, {"step_i", 8, -1, 1}};
  return stream;
}
const LegalInputs Legal({{"step", [](std::uint64_t raw) { return raw == 0 ? 1 : raw; }}});

class ShrinkTest : public testing::Test {
 protected:
  /// Where a stream fails, and how, if it does.
  using Fails = std::function<std::optional<StreamDifference>(const PortStream& stream)>;

  ShrinkTest() {
    std::mt19937 random(1);
    for (int clock = 0; clock < 300; ++clock) {
      noise.values.push_back(clock > 0 && random() % 40 != 0);
      for (int input = 0; input < 2; ++input) noise.values.push_back(random() & 0xff);
      noise.values.push_back(1 + random() % 255);
    }
  }
  std::optional<ShrunkStream> shrunk(const Fails& fails, const ShrinkEffort& effort = {}) {
    const auto find = [&](const std::string& port, std::size_t count,
                          const Streams& streams) -> std::optional<StreamHit> {
      for (std::size_t number = 0; number < count; ++number) {
        const PortStream stream = streams(number);
        if (stream.clocks() < 2) continue;
        played += stream.clocks();
        if (const auto d = fails(stream); d && d->port == port) return StreamHit{number, *d};
      }
      return std::nullopt;
    };
    return shrink(noise, "x_o", Legal, find, effort);
  }
  static StreamDifference at(std::uint64_t clock) { return {clock, "x_o", 1, 0}; }

  PortStream noise = form();
  std::uint64_t played = 0;
};

TEST_F(ShrinkTest, WhatNeedsOneClockAndOneBitIsThat) {
  const auto small = shrunk([](const PortStream& stream) -> std::optional<StreamDifference> {
    for (std::uint64_t clock = 1; clock < stream.clocks(); ++clock)
      if (stream.at(clock, A) & 0x10) return at(clock);
    return std::nullopt;
  });
  ASSERT_TRUE(small);
  EXPECT_EQ(small->stream.clocks(), 2u) << "one after the reset";
  EXPECT_EQ(small->stream.moving(), 0u);
  EXPECT_EQ(small->stream.at(1, A), 0x10u);
  EXPECT_EQ(small->stream.at(1, B), 0u);
  EXPECT_EQ(small->stream.at(1, Step), 1u) << "0 means nothing there";
  EXPECT_EQ(small->stream.at(0, Reset), 0u);
  EXPECT_EQ(small->stream.at(1, Reset), 1u);
}

TEST_F(ShrinkTest, AMemoryOfThreeThingsKeepsThreeClocksAndTheInputThatMoves) {
  // Odd, even, odd in b_i, not necessarily side by side, and no reset between.
  const auto small = shrunk([](const PortStream& stream) -> std::optional<StreamDifference> {
    unsigned seen = 0;
    for (std::uint64_t clock = 1; clock < stream.clocks(); ++clock) {
      if (stream.at(clock, Reset) == 0) seen = 0;
      else if ((stream.at(clock, B) & 1) != seen % 2 && ++seen == 3) return at(clock);
    }
    return std::nullopt;
  });
  ASSERT_TRUE(small);
  EXPECT_EQ(small->stream.clocks(), 4u);
  EXPECT_EQ(small->stream.moving(), 1u);
  EXPECT_TRUE(small->stream.moves(B));
  EXPECT_EQ(small->difference.clock, 3u);
}

TEST_F(ShrinkTest, AnotherPortIsAnotherDifference) {
  EXPECT_FALSE(shrunk([](const PortStream& stream) -> std::optional<StreamDifference> {
    return StreamDifference{stream.clocks() - 1, "y_o", 1, 0};
  }));
}

TEST_F(ShrinkTest, TheFrameThatMattersIsKept) {
  noise.seeks = {{3, 7}, {290, 9}, {295, 8}};
  const auto small = shrunk([](const PortStream& stream) -> std::optional<StreamDifference> {
    for (const auto& [clock, frame] : stream.seeks)
      if (frame == 7) return at(stream.clocks() - 1);
    return std::nullopt;
  });
  ASSERT_TRUE(small);
  EXPECT_EQ(small->stream.clocks(), 2u);
  EXPECT_EQ(small->stream.seeks, (std::map<std::uint64_t, int>{{1, 7}}));
}

TEST_F(ShrinkTest, TheEffortIsBoundedAndItsResultStillFails) {
  const Fails fails = [](const PortStream& stream) -> std::optional<StreamDifference> {
    if (stream.clocks() < 200) return std::nullopt;
    return at(stream.clocks() - 1);
  };
  ShrinkEffort little;
  little.clocks = 5000;
  const auto small = shrunk(fails, little);
  ASSERT_TRUE(small);
  EXPECT_TRUE(fails(small->stream));
  EXPECT_LE(played, little.clocks);
}

TEST_F(ShrinkTest, TheSameStreamGivesTheSameResult) {
  const Fails fails = [](const PortStream& stream) -> std::optional<StreamDifference> {
    std::uint64_t sum = 0;
    for (std::uint64_t clock = 1; clock < stream.clocks(); ++clock)
      if ((sum += stream.at(clock, A)) > 1000) return at(clock);
    return std::nullopt;
  };
  const auto one = shrunk(fails), other = shrunk(fails);
  ASSERT_TRUE(one && other);
  EXPECT_EQ(one->stream.values, other->stream.values);
  EXPECT_EQ(one->plays, other->plays);
}

}  // namespace
}  // namespace racebeam
