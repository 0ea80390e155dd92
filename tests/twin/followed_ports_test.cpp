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
#include "sc/swap/followed_wires.h"

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

TEST_F(FollowedPortsTest, InputsHaveWhatTheWiresHaveAndAMoveIsTold) {
  bool bit = false;
  std::array<sc_dt::sc_uint_base, 5> words{{sc_dt::sc_uint_base(8), sc_dt::sc_uint_base(13),
                                            sc_dt::sc_uint_base(32), sc_dt::sc_uint_base(64),
                                            sc_dt::sc_uint_base(40)}};
  followed_wires wires;
  EXPECT_TRUE(wires.empty());
  wires.add({&bit, nullptr}, table[0]);
  for (std::size_t n = 0; n < words.size(); ++n) wires.add({nullptr, &words[n]}, table[n + 1]);
  EXPECT_FALSE(wires.empty());
  EXPECT_FALSE(wires.take()) << "all are 0";
  for (int clock = 0; clock < 10000; ++clock) {
    const std::size_t n = random() % table.size();
    const std::uint64_t value = random() % 4 ? any_value(table[n]) : port_value(table[n]);
    if (n == 0) bit = value != 0;
    else words[n - 1] = value;
    const bool moves = value != port_value(table[n]);
    ASSERT_EQ(wires.take(), moves) << table[n].name << " at clock " << clock;
    ASSERT_EQ(port_value(table[n]), value) << table[n].name;
    ASSERT_FALSE(wires.take());
  }
}

}  // namespace
}  // namespace racebeam
