// What wires of the chip and ports of verilated RTL say to each other: no move is missed, none is
// told twice.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <deque>
#include <map>
#include <random>
#include <string>
#include <tuple>
#include <utility>

#include "sc/swap/changed_ports.h"
#include "sc/swap/wire_place.h"

namespace racebeam {
namespace {

/// As a verilated class has its ports: by size, with other bytes between.
struct alignas(8) Ports {
  std::uint8_t bit, other, byte;
  std::uint16_t half;
  std::uint32_t word;
  std::uint64_t wide, last;
};

class FollowedPortsTest : public testing::Test {
 protected:
  Ports ports{};
  const std::array<rtl_port, 6> table{{{"bit", 1, 1, 0, &ports.bit, nullptr, 0},
                                       {"byte", 8, 1, 0, &ports.byte, nullptr, 0},
                                       {"half", 13, 2, 0, &ports.half, nullptr, 0},
                                       {"word", 32, 4, 0, &ports.word, nullptr, 0},
                                       {"wide", 64, 8, 0, &ports.wide, nullptr, 0},
                                       {"last", 40, 8, 0, &ports.last, nullptr, 0}}};
  std::mt19937_64 random{7};
  std::uint64_t any_value(const rtl_port& port) { return random() >> (64 - port.bits); }
};

TEST_F(FollowedPortsTest, EachPortThatMovedIsToldOnceWithItsValue) {
  std::vector<const rtl_port*> all;
  for (const rtl_port& port : table) all.push_back(&port);
  changed_ports changes(all);
  std::map<std::size_t, std::uint64_t> known;
  for (int clock = 0; clock < 10000; ++clock) {
    ports.other = static_cast<std::uint8_t>(random());  // none of the ports
    std::map<std::size_t, std::uint64_t> moved;
    for (std::size_t n = 0; n < table.size(); ++n) {
      if (random() % 3 != 0) continue;
      const std::uint64_t value = any_value(table[n]);
      std::memcpy(table[n].data, &value, static_cast<std::size_t>(table[n].bytes));
      if (value != known[n]) moved[n] = known[n] = value;
    }
    std::map<std::size_t, std::uint64_t> told;
    changes.visit([&](std::size_t n, std::uint64_t value) {
      EXPECT_TRUE(told.emplace(n, value).second) << table[n].name << " twice";
    });
    ASSERT_EQ(told, moved) << "clock " << clock;
  }
}

TEST_F(FollowedPortsTest, AWireOfOneBitIsABoolAndAnotherAWholeWord) {
  const bool bit = true;
  EXPECT_TRUE(*static_cast<const bool*>(place_of({&bit, nullptr})));
  for (int bits = 2; bits <= 64; ++bits) {
    sc_dt::sc_uint_base word(bits);
    word = random();
    const wire_contents wire{nullptr, &word};
    const auto* place = static_cast<const std::uint64_t*>(place_of(wire));
    EXPECT_EQ(*place, word.value());
    put(wire, 1);
    EXPECT_EQ(*place, 1u);
  }
}

/// A wire, and what follows it.
template <int Bits>
struct Followed {
  static constexpr int bits = Bits;
  wire<Bits> of{("wire_" + std::to_string(Bits)).c_str()};
  follower_place<Bits> place = 0;
  std::uint64_t known = 0;
};

class Follower : public sc_core::sc_module {
 public:
  explicit Follower(const sc_core::sc_module_name& name) : sc_module(name) {
    SC_HAS_PROCESS(Follower);
    SC_METHOD(wake);
    sensitive << woken;
    dont_initialize();
  }
  sc_core::sc_event woken{"woken"};
  int wakes = 0;

 private:
  void wake() { ++wakes; }
};

TEST_F(FollowedPortsTest, AFollowerHasWhatItsWireHasAndIsWokenAtEachChange) {
  std::tuple<Followed<1>, Followed<8>, Followed<13>, Followed<32>, Followed<40>, Followed<64>> all;
  Follower follower("follower");
  std::uint32_t moved = 0, bit = 1;
  std::deque<wire_follower> followers;
  std::apply(
      [&](auto&... one) {
        ((followers.push_back({&one.place, &moved, 0, &follower.woken}),
          one.of.add(followers.back())),
         ...);
      },
      all);
  for (wire_follower& one : followers) one.bit = std::exchange(bit, bit << 1);
  for (int n = 0; n < 1000; ++n) {
    std::uint32_t expected = 0, number = 1;
    const auto drive = [&](auto& one) {
      if (random() % 3 == 0) {
        const std::uint64_t value = random() & (~std::uint64_t{0} >> (64 - one.bits));
        one.of.drive(value);
        if (std::exchange(one.known, value) != value) expected |= number;
      }
      number <<= 1;
    };
    std::apply([&](auto&... one) { (drive(one), ...); }, all);
    const int woken_before = follower.wakes;
    sc_core::sc_start(1, sc_core::SC_NS);
    EXPECT_EQ(std::exchange(moved, 0), expected);
    EXPECT_EQ(follower.wakes - woken_before, expected != 0) << "once for all";
    const auto follows = [](const auto& one) { EXPECT_EQ(one.place, one.known) << one.bits; };
    std::apply([&](const auto&... one) { (follows(one), ...); }, all);
  }
}

}  // namespace
}  // namespace racebeam
