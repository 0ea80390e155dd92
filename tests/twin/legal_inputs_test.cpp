// Rules of inputs make values that the chip can have, and leave such values as they are.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/legal_inputs.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <random>
#include <string>

#include "sc/base/engine.h"
#include "tb/twin/traffic_tap.h"
#include "tb/twin/twins.h"

namespace racebeam {
namespace {

using Raw = std::uint64_t;

/// All values of a narrow port, some of a wide one.
void for_values(int bits, const std::function<void(Raw)>& take) {
  constexpr int Narrow = 16, Some = 1 << Narrow;
  std::mt19937_64 random(1);
  for (Raw n = 0; n < (bits > Narrow ? Raw{Some} : Raw{1} << bits); ++n)
    take(bits > Narrow ? raw_bits(random(), bits) : n);
}

TEST(LegalInputsTest, LegalValuesOfEachUnitOfEachEngineStayAsTheyAre) {
  int looked_at = 0;
  for (const Twins& row : twins()) {
    const knob_values k = row.engine.standard(nullptr);
    for (const std::string& unit : row.engine.unit_names(false)) {
      const LegalInputs legal = row.inputs(k, nullptr, unit);
      const auto model =
          row.engine.unit(unit)->make((row.engine.name + ("_" + unit)).c_str(), k, nullptr);
      for (const PortTraffic::Port& port : traffic_ports(*model)) {
        if (!port.input) continue;
        ++looked_at;
        bool same = true;
        for_values(port.bits, [&](Raw raw) {
          const Raw value = raw_bits(legal.legal(port.name, raw), port.bits);
          same &= raw_bits(legal.legal(port.name, value), port.bits) == value;
          const Raw driven = raw_bits(legal.of(port.name, raw), port.bits);
          same &= raw_bits(legal.legal(port.name, driven), port.bits) == driven;
        });
        EXPECT_TRUE(same) << row.engine.name << " " << unit << " " << port.name;
      }
    }
  }
  EXPECT_GT(looked_at, 400);
}

TEST(LegalInputsTest, AScanLineIsAnyOfTheFrameAndNoOther) {
  const LegalInputs legal({scan_line()});
  int lines = 0;
  for (Raw raw = 0; raw < 1024; ++raw) {
    const auto line = signed_bits(legal.of("y_i", raw), 10);
    EXPECT_GE(line, FirstLine);
    EXPECT_LE(line, LastLine);
    lines += raw_bits(legal.of("y_i", raw), 10) == raw;
  }
  EXPECT_EQ(lines, FrameLines);
}

}  // namespace
}  // namespace racebeam
