// Files of port traffic: what was written is read, any clock can be sought, and a file that is not
// whole is refused, whichever byte of it is wrong.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/traffic_file.h"

#include <gmock/gmock.h>

#include <fstream>
#include <random>

#include "tb/base/errors.h"
#include "tb/base/whole_file.h"
#include "tb/twin/traffic_codec.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {
namespace {

using testing::HasSubstr;

constexpr std::uint64_t Clocks = 70000;  // three blocks

std::uint64_t value(std::uint64_t clock, int port) {
  return port == 0 ? clock % 800 : clock % 1000 < 3 ? 0xfedcba9876543210 + clock : 7;
}

class TrafficFileTest : public testing::Test {
 protected:
  void write(std::uint64_t clocks) {
    TrafficHead head{"0.0", "unit", "engine", "a scene", "hash", "chip", {{"knob", -3}}, {}};
    head.ports = {{"x_i", 10, true}, {"wide_o", 64, false, true}};
    TrafficWriter writer(path, head);
    for (std::uint64_t clock = 0; clock < clocks; ++clock) {
      if (clock == 1) {
        const std::uint64_t row[] = {9, 9};
        writer.add(row, true);
        writer.add(row, true);
        writer.mark(33);
      }
      const std::uint64_t row[] = {value(clock, 0), value(clock, 1)};
      writer.add(row, false);
    }
    EXPECT_FALSE(std::filesystem::exists(path));
    writer.commit();
  }
  void put(const std::string& bytes) const {
    std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
  }
  std::string refusal() const {
    try {
      TrafficFile file(path);
    } catch (const UsageError& error) {
      return error.what();
    }
    return "";
  }

  ScratchFolder folder;
  const std::string path = folder / "unit.traffic";
};

TEST_F(TrafficFileTest, WhatWasWrittenIsRead) {
  write(Clocks);
  TrafficFile file(path);
  EXPECT_EQ(file.head().scene, "a scene");
  EXPECT_EQ(file.head().knobs.at(0).second, -3);
  EXPECT_TRUE(file.head().ports.at(1).optional);
  EXPECT_EQ(file.clocks(), Clocks);
  ASSERT_EQ(file.marks().size(), 1u);
  EXPECT_EQ(file.marks()[0].clock, 1u);
  EXPECT_EQ(file.marks()[0].frame, 33);
  std::uint64_t clock = 0, own = 0, wrong = 0;
  for (TrafficBlock block; file.next(block);) {
    EXPECT_EQ(block.first, clock);
    for (std::size_t at = 0; at < block.values.size(); at += 2) {
      if (block.is_private) own += block.values[at] == 9;
      else wrong += block.values[at] != value(clock, 0) || block.values[at + 1] != value(clock, 1);
      clock += !block.is_private;
    }
  }
  EXPECT_EQ(clock, Clocks);
  EXPECT_EQ(own, 2u);
  EXPECT_EQ(wrong, 0u);
}

TEST_F(TrafficFileTest, AnyClockIsSought) {
  write(Clocks);
  TrafficFile file(path);
  for (const std::uint64_t clock : {69999u, 0u, 1u, 32768u, 32769u, 40000u, 2u}) {
    file.seek(clock);
    TrafficBlock block;
    ASSERT_TRUE(file.next(block));
    ASSERT_FALSE(block.is_private);
    ASSERT_GE(clock, block.first);
    ASSERT_LT(2 * (clock - block.first), block.values.size());
    EXPECT_EQ(block.values[2 * (clock - block.first)], value(clock, 0));
  }
}

TEST_F(TrafficFileTest, AFrameOfCountersCostsLittle) {
  write(Clocks);
  EXPECT_LT(std::filesystem::file_size(path), Clocks / 30);
}

TEST_F(TrafficFileTest, EveryFlippedBitIsRefused) {
  write(300);
  const std::string good = whole_file(path);
  for (std::size_t byte = 0; byte < good.size(); ++byte) {
    std::string bad = good;
    bad[byte] = static_cast<char>(bad[byte] ^ 1 << byte % 8);
    put(bad);
    EXPECT_THAT(refusal(), HasSubstr(path)) << "byte " << byte << " of " << good.size();
  }
  put(good);
  EXPECT_EQ(refusal(), "");
}

TEST_F(TrafficFileTest, EveryCutIsRefused) {
  write(300);
  const std::string good = whole_file(path);
  for (std::size_t size = 0; size < good.size(); ++size) {
    put(good.substr(0, size));
    EXPECT_NE(refusal(), "") << size << " bytes of " << good.size();
  }
  put(good + "x");
  EXPECT_THAT(refusal(), HasSubstr("cut short, or something follows it"));
}

TEST_F(TrafficFileTest, AnotherVersionIsNamed) {
  write(10);
  std::string text = whole_file(path);
  text.replace(text.find(" 1\n"), 3, " 2\n");
  put(text);
  EXPECT_THAT(refusal(), HasSubstr("its format is version 2, and this program reads 1"));
}

TEST_F(TrafficFileTest, AFolderAndNothingAreRefused) {
  EXPECT_THAT(refusal(), HasSubstr("cannot read"));
  std::filesystem::create_directory(path);
  EXPECT_THAT(refusal(), HasSubstr("no file"));
}

TEST(TrafficCodec, AnyValuesComeBack) {
  std::mt19937_64 random(1);
  for (const std::size_t ports : {1u, 3u, 20u}) {
    std::vector<std::uint64_t> values(ports * 500), back;
    for (auto& one : values) one = random() >> random() % 64;
    ASSERT_TRUE(unpack_traffic(pack_traffic(values, ports), ports, 500, back));
    EXPECT_EQ(back, values);
    EXPECT_FALSE(unpack_traffic(pack_traffic(values, ports), ports, 499, back));
  }
}

}  // namespace
}  // namespace racebeam
