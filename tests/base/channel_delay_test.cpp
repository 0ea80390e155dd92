// Promises of sc/base/channel_delay.h, on both twins, and that these are the same.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/base/channel_delay.h"

#include <gtest/gtest.h>

#include <deque>
#include <random>
#include <string>

#include "sc/swap/rtl_twin.h"
#include "tb/base/project_folder.h"
#include "tb/twin/unit_bench.h"
#include "tb/verilate/rtl_plugin.h"

namespace racebeam {
namespace {

/// The RTL behind the model's pins.
struct channel_delay_rtl : rtl_twin<channel_delay> {
  channel_delay_rtl(const char* name, int latency, int capacity)
      : rtl_twin(name, {}, plugin(latency, capacity)) {}

 private:
  static std::string plugin(int latency, int capacity) {
    RtlSources sources{"channel_delay", {rtl_file("channel_delay")}};
    sources.parameters = {"Latency=" + std::to_string(latency),
                          "Capacity=" + std::to_string(capacity)};
    return rtl_plugin(sources);
  }
};

template <class Unit>
class ChannelDelayTest : public testing::Test {
 public:
  void make(int latency, int capacity) {
    unit = std::make_unique<Unit>("dut", latency, capacity);
    bench = std::make_unique<UnitBench>(*unit);
    drive(0, 0, 0);
    pin("clear_i").drive(1);
    bench->clock();
    pin("clear_i").drive(0);
    bench->settle();
  }
  UnitBench::Pin& pin(const char* name) { return (*bench)[name]; }
  void drive(bool offer, std::uint64_t data, bool take) {
    pin("offer_valid_i").drive(offer);
    pin("offer_data_i").drive(data);
    pin("take_ready_i").drive(take);
    bench->settle();
  }
  std::unique_ptr<Unit> unit;
  std::unique_ptr<UnitBench> bench;
};

using Twins = testing::Types<channel_delay, channel_delay_rtl>;
TYPED_TEST_SUITE(ChannelDelayTest, Twins);

TYPED_TEST(ChannelDelayTest, OfferIsSeenLatencyClocksLaterAndStaysUntilTaken) {
  this->make(3, 3);
  this->drive(1, 0xfedcba9876543210, 0);
  EXPECT_EQ(this->pin("offer_ack_o").value(), 1u);
  for (int clock = 1; clock <= 6; ++clock) {
    this->bench->clock();
    this->drive(0, 0, 0);
    ASSERT_EQ(this->pin("take_valid_o").value(), clock >= 3) << clock;
  }
  EXPECT_EQ(this->pin("take_data_o").value(), 0xfedcba9876543210u);
  this->drive(0, 0, 1);
  this->bench->clock();
  EXPECT_EQ(this->pin("take_valid_o").value(), 0u);
}

TYPED_TEST(ChannelDelayTest, WithAnEntryMoreThanLatencyAnOfferInEveryClockIsTaken) {
  this->make(2, 3);
  for (int clock = 0; clock < 20; ++clock) {
    this->drive(1, static_cast<std::uint64_t>(clock), 1);
    ASSERT_EQ(this->pin("offer_ack_o").value(), 1u) << clock;
    if (clock >= 2) {
      ASSERT_EQ(this->pin("take_data_o").value(), clock - 2u);
    }
    this->bench->clock();
  }
}

TYPED_TEST(ChannelDelayTest, NothingIsTakenWhenAllEntriesAreInUse) {
  this->make(1, 2);
  for (int offer = 0; offer < 4; ++offer) {
    this->drive(1, static_cast<std::uint64_t>(offer), 0);
    EXPECT_EQ(this->pin("offer_ack_o").value(), offer < 2) << offer;
    EXPECT_EQ(this->pin("offer_ready_o").value(), offer < 2) << offer;
    this->bench->clock();
  }
  EXPECT_EQ(this->pin("take_data_o").value(), 0u) << "the oldest";
}

TYPED_TEST(ChannelDelayTest, ClearForgetsWhatIsOnTheWay) {
  this->make(4, 5);
  for (int offer = 0; offer < 3; ++offer) {
    this->drive(1, 1, 0);
    this->bench->clock();
  }
  this->drive(1, 1, 0);
  this->pin("clear_i").drive(1);
  this->bench->clock();
  this->pin("clear_i").drive(0);
  for (int clock = 0; clock < 8; ++clock) {
    this->drive(0, 0, 0);
    ASSERT_EQ(this->pin("take_valid_o").value(), 0u) << clock;
    this->bench->clock();
  }
}

// Against a list of offers with the clock of each, with random stalls on both sides.
template <class Test>
void expect_list(Test& test, int latency, int capacity) {
  struct Entry {
    int clock;
    std::uint64_t data;
  };
  test.make(latency, capacity);
  std::minstd_rand random(7);
  std::deque<Entry> list;
  for (int clock = 0; clock < 4000; ++clock) {
    const bool busy = clock / 100 % 2;
    const bool offer = random() % 4 != 0, take = random() % 4 < (busy ? 1 : 3);
    const std::uint64_t data = static_cast<std::uint64_t>(random()) << 32 | random();
    test.drive(offer, data, take);
    const bool free = list.size() < static_cast<std::size_t>(capacity);
    const bool seen = !list.empty() && clock - list.front().clock >= latency;
    ASSERT_EQ(test.pin("offer_ready_o").value(), free) << "seed 7, clock " << clock;
    ASSERT_EQ(test.pin("offer_ack_o").value(), offer && free) << "seed 7, clock " << clock;
    ASSERT_EQ(test.pin("take_valid_o").value(), seen) << "seed 7, clock " << clock;
    if (seen) {
      ASSERT_EQ(test.pin("take_data_o").value(), list.front().data) << clock;
    }
    if (take && seen) list.pop_front();
    if (offer && free) list.push_back({clock, data});
    test.bench->clock();
  }
}

TYPED_TEST(ChannelDelayTest, IsAListOfOffersWithOneEntry) { expect_list(*this, 1, 1); }
TYPED_TEST(ChannelDelayTest, IsAListOfOffersWithAnEntryAClock) { expect_list(*this, 3, 3); }
TYPED_TEST(ChannelDelayTest, IsAListOfOffersWithMoreEntries) { expect_list(*this, 8, 13); }

}  // namespace
}  // namespace racebeam
