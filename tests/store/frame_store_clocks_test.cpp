// Promises of sc/store/frame_store.h: the closed form is the units, clock by clock.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <optional>
#include <random>

#include "sc/store/frame_store.h"
#include "tests/store/frame_store_loop.h"
#include "tests/store/store_twins.h"

namespace racebeam {
namespace {

/// Random words, offered with pauses, to the units from their first clock after the reset, and to
/// the closed form.
void expect_the_units(store_knobs k, int clocks_per_pixel, int busy) {
  SCOPED_TRACE(testing::Message() << "format " << k.store_format << ", policy " << k.write_policy
                                  << ", " << clocks_per_pixel << " clocks a pixel");
  FrameStoreLoop units(k, clocks_per_pixel);
  units.clock(false, false, {});
  frame_store form(k, clocks_per_pixel);
  store_counters counted;
  std::uint64_t reads = 0, writes = 0, stalls = 0;
  std::mt19937_64 random(static_cast<unsigned>(k.write_policy + 3 * clocks_per_pixel));
  std::optional<write_buffer_core::entry> word;
  const int clocks = 36 * LinePixels * clocks_per_pixel;
  for (int n = 0; n < clocks; ++n) {
    if (!word && static_cast<int>(random() % 9) < busy)
      word = {static_cast<int>(random() % 4096), raw_bits(random(), k.data_bits())};
    const StoreClock now =
        units.clock(true, word.has_value(), word.value_or(write_buffer_core::entry{}));
    bool went_in = false;
    if (word) {
      ASSERT_EQ(form.clock(), n);
      went_in = form.offer(word->address, word->data, counted);
      ASSERT_EQ(went_in, now.put_ready) << "clock " << n;
    } else {
      form.go_to(n + 1, &counted);
    }
    stalls += word && !went_in;
    if (went_in) word.reset();
    reads += units.read();
    writes += now.mem_write;
    ASSERT_EQ(form.reads_before(n + 1), reads) << "clock " << n;
    ASSERT_EQ(counted.store_writes, writes) << "clock " << n;
  }
  EXPECT_EQ(counted.buffer_stalls, stalls);
  EXPECT_GT(writes, 100u);
  EXPECT_GT(reads, 100u);
  EXPECT_TRUE(form.memory() == units.memory());
}

TEST(FrameStoreClocks, AreTheUnits) {
  for (const int policy : {WritePolicySync, WritePolicyBlanking, WritePolicyFree})
    for (const int n : {1, 2, 3})
      for (store_knobs k : {rgb_light(), rgb888(), planar()}) {
        k.write_policy = policy;
        k.write_buffer_depth = 8;
        expect_the_units(k, n, policy == WritePolicyFree ? 8 : 1);
      }
}

TEST(FrameStoreClocks, LostWordsAreTheUnits) {
  store_knobs k = planar();
  k.write_policy = WritePolicySync;
  k.when_full = WhenFullDrop;
  k.write_buffer_depth = 5;
  expect_the_units(k, 2, 1);
}

}  // namespace
}  // namespace racebeam
