// Promises of sc/store/frame_memory.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/store/frame_memory.h"

#include <gtest/gtest.h>

#include <optional>

#include "tb/twin/unit_bench.h"
#include "tests/store/store_twins.h"

namespace racebeam {
namespace {

class FrameMemoryTest : public testing::Test {
 protected:
  void build(const store_knobs& k) {
    memory.emplace("dut", k);
    bench.emplace(*memory);
  }
  void clock(bool write, unsigned address, std::uint64_t data = 0) {
    (*bench)["mem_write_i"].drive(write);
    (*bench)["mem_address_i"].drive(address);
    (*bench)["mem_data_i"].drive(data);
    bench->clock();
  }
  std::uint64_t read(unsigned address) {
    clock(false, address);
    return data();
  }
  std::uint64_t data() { return (*bench)["mem_data_o"].value(); }

  std::optional<frame_memory> memory;
  std::optional<UnitBench> bench;
};

TEST_F(FrameMemoryTest, WordWrittenIsReadInTheNextClock) {
  build({});
  EXPECT_EQ(read(9), 0u) << "at power-up";
  clock(true, 9, 0xbeef);
  EXPECT_EQ(data(), 0u) << "not while it is written";
  EXPECT_EQ(read(9), 0xbeefu);
  EXPECT_EQ(memory->words().at(9), 0xbeefu);
}

TEST_F(FrameMemoryTest, WordReadStaysWhileOthersAreWritten) {
  build({});
  clock(true, 1, 11);
  EXPECT_EQ(read(1), 11u);
  for (unsigned n = 2; n < 9; ++n) {
    clock(true, n, 5 * n);
    EXPECT_EQ(data(), 11u);
  }
}

TEST_F(FrameMemoryTest, HasTheWordsAndBitsOfItsFormat) {
  build({});
  EXPECT_EQ(memory->words().size() * 16, 4'194'304u) << "bits of 512 x 512 words";
  clock(true, 0xc0005, ~std::uint64_t{0});
  EXPECT_EQ(read(5), 0xffffu);
}

TEST_F(FrameMemoryTest, HoldsWordsOf64Bits) {
  build(planar());
  clock(true, 0xfffff, 0xfedcba9876543210);
  EXPECT_EQ(read(0xfffff), 0xfedcba9876543210u);
}

TEST_F(FrameMemoryTest, WordsPutThereAreRead) {
  build(rgb888());
  memory->deposit(77, 0x123456);
  EXPECT_EQ(read(77), 0x123456u);
}

}  // namespace
}  // namespace racebeam
