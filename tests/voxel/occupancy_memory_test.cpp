// Promises of sc/voxel/occupancy_memory.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/occupancy_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <random>

#include "tb/twin/unit_bench.h"

namespace racebeam {
namespace {

class OccupancyMemoryTest : public testing::Test {
 protected:
  void build(const voxel_knobs& k = {}) {
    memory.emplace("dut", k);
    bench.emplace(*memory);
  }
  void build(int memory_clocks) {
    voxel_knobs k;
    k.memory_clocks = memory_clocks;
    build(k);
  }
  void clock(bool read, bool write, unsigned address = 0, std::uint32_t data = 0) {
    (*bench)["read_i"].drive(read);
    (*bench)["write_i"].drive(write);
    (*bench)["address_i"].drive(address);
    (*bench)["data_i"].drive(data);
    bench->clock();
  }
  std::uint64_t data() { return (*bench)["data_o"].value(); }

  std::optional<occupancy_memory> memory;
  std::optional<UnitBench> bench;
};

TEST_F(OccupancyMemoryTest, WordWrittenIsReadInTheNextClock) {
  build();
  clock(true, false, 9);
  EXPECT_EQ(data(), 0u) << "at power-up";
  clock(false, true, 9, 0xdeadbeef);
  EXPECT_EQ(data(), 0u) << "not while it is written";
  clock(true, false, 9);
  EXPECT_EQ(data(), 0xdeadbeefu);
  EXPECT_EQ(memory->words().at(9), 0xdeadbeefu);
}

TEST_F(OccupancyMemoryTest, WordReadStaysUntilTheNextRead) {
  build();
  memory->words().at(1) = 11;
  memory->words().at(2) = 22;
  clock(true, false, 1);
  clock(false, true, 1, 33);
  clock(true, true, 2, 44);
  clock(false, false, 2);
  EXPECT_EQ(data(), 11u);
  EXPECT_EQ(memory->words().at(2), 44u) << "a write goes before a read";
}

TEST_F(OccupancyMemoryTest, WordsComeAfterTheClocksOfTheKnobOneAClock) {
  build(5);
  for (unsigned n = 0; n < 20; ++n) memory->words().at(n) = 100 + n;
  for (unsigned n = 0; n < 30; ++n) {
    clock(n < 20, false, n < 20 ? n : 0);
    const unsigned late = std::min(n, 23u) - 4;
    ASSERT_EQ(data(), n < 4 ? 0 : 100 + std::min(late, 19u)) << "clock " << n;
  }
}

TEST_F(OccupancyMemoryTest, IsAsAnArrayIsHoweverItIsAsked) {
  build(3);
  std::mt19937 random(4);
  std::vector<std::uint32_t> words(1216u);
  ASSERT_EQ(memory->words().size(), words.size());
  std::vector<std::uint32_t> reads(3);
  for (int n = 0; n < 20'000; ++n) {
    const bool busy = n / 50 % 3 != 0;
    const bool read = busy && random() % 2, write = busy && random() % 3 == 0;
    const unsigned address = random() % 16 * 300;
    const auto data_in = static_cast<std::uint32_t>(random());
    const bool there = address < words.size();
    reads.push_back(!read || write ? reads.back() : there ? words[address] : 0);
    if (write && there) words[address] = data_in;
    clock(read, write, address, data_in);
    ASSERT_EQ(data(), reads[reads.size() - 3]) << "clock " << n;
  }
  EXPECT_EQ(memory->words(), words);
}

TEST_F(OccupancyMemoryTest, HasAWordFor32VoxelsOfEachLevel) {
  voxel_knobs k;
  k.voxel_y = 1;
  build(k);
  EXPECT_EQ(memory->words().size(), 4720u);
}

}  // namespace
}  // namespace racebeam
