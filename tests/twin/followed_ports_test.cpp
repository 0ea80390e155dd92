// What wires of the chip and ports of verilated RTL say to each other: no move is missed, none is
// told twice.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <random>

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
  const std::array<rtl_port, 6> table{{{"bit", 1, 1, 0, &ports.bit},
                                       {"byte", 8, 1, 0, &ports.byte},
                                       {"half", 13, 2, 0, &ports.half},
                                       {"word", 32, 4, 0, &ports.word},
                                       {"wide", 64, 8, 0, &ports.wide},
                                       {"last", 40, 8, 0, &ports.last}}};
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

}  // namespace
}  // namespace racebeam
