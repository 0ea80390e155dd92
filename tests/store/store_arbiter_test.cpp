// Promises of sc/store/store_arbiter.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/store/store_arbiter.h"

#include <gtest/gtest.h>

#include "tb/twin/unit_bench.h"
#include "tests/store/store_twins.h"

namespace racebeam {
namespace {

template <class Unit>
class StoreArbiterTest : public testing::Test {
 protected:
  /// All values of the inputs of one bit. `may`: what of sync_i and blank_i lets words through.
  void check(int policy, bool (*may)(bool sync, bool blank)) {
    constexpr unsigned Read = 0x12345, Take = 0xfedcb;
    constexpr std::uint64_t Data = 0xfedcba9876543210;
    store_knobs k;
    k.write_policy = policy;
    Unit unit("dut", k);
    UnitBench bench(unit);
    bench["read_address_i"].drive(Read);
    bench["take_address_i"].drive(Take);
    bench["take_data_i"].drive(Data);
    for (unsigned bits = 0; bits < 16; ++bits) {
      const bool read = bits & 1, sync = bits & 2, blank = bits & 4, valid = bits & 8;
      bench["read_i"].drive(read);
      bench["sync_i"].drive(sync);
      bench["blank_i"].drive(blank);
      bench["take_valid_i"].drive(valid);
      bench.settle();
      SCOPED_TRACE(testing::Message() << "read " << read << ", sync " << sync << ", blank " << blank
                                      << ", valid " << valid);
      const bool ready = may(sync, blank) && !read;
      EXPECT_EQ(bench["take_ready_o"].value(), ready);
      EXPECT_EQ(bench["mem_write_o"].value(), ready && valid);
      EXPECT_EQ(bench["mem_address_o"].value(), ready && valid ? Take : Read);
      EXPECT_EQ(bench["mem_data_o"].value(), Data);
    }
  }
};

using Twins = testing::Types<store_arbiter, own_store_rtl<store_arbiter>>;
TYPED_TEST_SUITE(StoreArbiterTest, Twins);

TYPED_TEST(StoreArbiterTest, SyncLetsWordsThroughWhileASyncIsLow) {
  this->check(WritePolicySync, [](bool sync, bool) { return sync; });
}
TYPED_TEST(StoreArbiterTest, BlankingLetsWordsThroughWhereNoPixelIsVisible) {
  this->check(WritePolicyBlanking, [](bool, bool blank) { return blank; });
}
TYPED_TEST(StoreArbiterTest, FreeLetsWordsThroughWheneverTheBeamDoesNotRead) {
  this->check(WritePolicyFree, [](bool, bool) { return true; });
}

}  // namespace
}  // namespace racebeam
