// What both memories of the voxel tracer promise.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <random>

#include "sc/voxel/knobs.h"
#include "tb/twin/unit_bench.h"

namespace racebeam {

template <class Memory>
class VoxelMemory : public testing::Test {
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

  std::optional<Memory> memory;
  std::optional<UnitBench> bench;
};

TYPED_TEST_SUITE_P(VoxelMemory);

TYPED_TEST_P(VoxelMemory, WordWrittenIsReadInTheNextClock) {
  this->build();
  this->clock(true, false, 9);
  EXPECT_EQ(this->data(), 0u) << "at power-up";
  this->clock(false, true, 9, 0xdeadbeef);
  EXPECT_EQ(this->data(), 0u) << "not while it is written";
  this->clock(true, false, 9);
  EXPECT_EQ(this->data(), 0xdeadbeefu);
  EXPECT_EQ(this->memory->words().at(9), 0xdeadbeefu);
}

TYPED_TEST_P(VoxelMemory, WordReadStaysUntilTheNextRead) {
  this->build();
  this->memory->words().at(1) = 11;
  this->memory->words().at(2) = 22;
  this->clock(true, false, 1);
  this->clock(false, true, 1, 33);
  this->clock(true, true, 2, 44);
  this->clock(false, false, 2);
  EXPECT_EQ(this->data(), 11u);
  EXPECT_EQ(this->memory->words().at(2), 44u) << "a write goes before a read";
}

TYPED_TEST_P(VoxelMemory, WordsComeAfterTheClocksOfTheKnobOneAClock) {
  this->build(5);
  for (unsigned n = 0; n < 20; ++n) this->memory->words().at(n) = 100 + n;
  for (unsigned n = 0; n < 30; ++n) {
    this->clock(n < 20, false, n < 20 ? n : 0);
    const unsigned late = std::min(n, 23u) - 4;
    ASSERT_EQ(this->data(), n < 4 ? 0 : 100 + std::min(late, 19u)) << "clock " << n;
  }
}

TYPED_TEST_P(VoxelMemory, IsAsAnArrayIsHoweverItIsAsked) {
  this->build(3);
  std::mt19937 random(4);
  std::vector<std::uint32_t> words(this->memory->words().size());
  std::vector<std::uint32_t> reads(3);
  for (int n = 0; n < 20'000; ++n) {
    const bool busy = n / 50 % 3 != 0;
    const bool read = busy && random() % 2, write = busy && random() % 3 == 0;
    const unsigned address = random() % 16 * 300;
    const auto data_in = static_cast<std::uint32_t>(random());
    const bool there = address < words.size();
    reads.push_back(!read || write ? reads.back() : there ? words[address] : 0);
    if (write && there) words[address] = data_in;
    this->clock(read, write, address, data_in);
    ASSERT_EQ(this->data(), reads[reads.size() - 3]) << "clock " << n;
  }
  EXPECT_EQ(this->memory->words(), words);
}

REGISTER_TYPED_TEST_SUITE_P(VoxelMemory, WordWrittenIsReadInTheNextClock,
                            WordReadStaysUntilTheNextRead,
                            WordsComeAfterTheClocksOfTheKnobOneAClock,
                            IsAsAnArrayIsHoweverItIsAsked);

}  // namespace racebeam
