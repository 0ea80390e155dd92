// Units may have ports of 64 bits: RTL in their place and beside them, traffic and words are right
// in every bit.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <string>

#include "sc/swap/rtl_twin.h"
#include "tb/twin/lockstep.h"
#include "tb/twin/lockstep_report.h"
#include "tb/twin/random_traffic.h"
#include "tb/twin/unit_bench.h"
#include "tb/verilate/rtl_plugin.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {
namespace {

constexpr std::uint64_t TopBit = std::uint64_t{1} << 63;

class wide_sum_pins : public sc_core::sc_module {
 public:
  in_port<1> clk_i{"clk_i"};
  in_port<1> rst_ni{"rst_ni"};
  in_port<64> a_i{"a_i"};
  in_port<33> b_i{"b_i"};           // signed
  out_port<64> sum_o{"sum_o"};      // a + b, a clock later
  out_port<33> least_o{"least_o"};  // signed, the least b since the reset
  out_port<32> low_o{"low_o"};      // of a

  explicit wide_sum_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

class wide_sum : public wide_sum_pins {
 public:
  using pins = wide_sum_pins;
  static constexpr const char* unit_name = "wide_sum";

  explicit wide_sum(const sc_core::sc_module_name& name) : wide_sum_pins(name) {
    SC_HAS_PROCESS(wide_sum);
    SC_METHOD(seq);
    sensitive << clk_i.pos();
    dont_initialize();
    SC_METHOD(comb);
    sensitive << a_i;
  }

 private:
  void seq() {
    const bool runs = rst_ni.value();
    sum_ = runs ? a_i.value() + static_cast<std::uint64_t>(b_i.signed_value()) : 0;
    least_ = runs ? std::min(least_, b_i.signed_value()) : 0;
    sum_o.drive(sum_);
    least_o.drive(static_cast<std::uint64_t>(least_));
  }
  void comb() { low_o.drive(a_i.value()); }

  std::uint64_t sum_ = 0;
  std::int64_t least_ = 0;
};

constexpr const char* Rtl = R"(
module wide_sum (
  input  logic               clk_i, rst_ni,
  input  logic [63:0]        a_i,
  input  logic signed [32:0] b_i,
  output logic [63:0]        sum_o,
  output logic signed [32:0] least_o,
  output logic [31:0]        low_o
);
  assign low_o = a_i[31:0];
  always_ff @(posedge clk_i)
    if (!rst_ni) begin
      sum_o   <= '0;
      least_o <= '0;
    end else begin
      sum_o   <= a_i + 64'(b_i);
      least_o <= b_i < least_o ? b_i : least_o;
    end
endmodule
)";

/// The plug-in of that, with `from` made `to`.
std::string plugin(const std::string& from = "", const std::string& to = "") {
  const ScratchFolder folder;
  std::string text = Rtl;
  if (!from.empty()) text.replace(text.find(from), from.size(), to);
  std::ofstream(folder / "wide_sum.sv") << text;
  return rtl_plugin({"wide_sum", {folder / "wide_sum.sv"}});
}

struct own_wide_sum : rtl_twin<wide_sum> {
  explicit own_wide_sum(const sc_core::sc_module_name& name) : rtl_twin(name, {}, plugin()) {}
};

template <class Unit>
class WidePorts : public testing::Test {
 protected:
  WidePorts() {
    bench.clock();
    bench["rst_ni"].drive(1);
  }
  void add(std::uint64_t a, std::int64_t b) {
    bench["a_i"].drive(a);
    bench["b_i"].drive(static_cast<std::uint64_t>(b));
    bench.clock();
  }

  Unit unit{"unit"};
  UnitBench bench{unit};
};

using Twins = testing::Types<wide_sum, own_wide_sum>;
TYPED_TEST_SUITE(WidePorts, Twins);

TYPED_TEST(WidePorts, CarryAllBitsAndTheSign) {
  this->add(TopBit + 5, -7);
  EXPECT_EQ(this->bench["sum_o"].value(), TopBit - 2);
  EXPECT_EQ(this->bench["least_o"].signed_value(), -7);
  this->add(TopBit | 0xfedcba98, -(std::int64_t{1} << 32));
  EXPECT_EQ(this->bench["sum_o"].value(), (TopBit | 0xfedcba98) - (std::uint64_t{1} << 32));
  EXPECT_EQ(this->bench["least_o"].signed_value(), -(std::int64_t{1} << 32));
  EXPECT_EQ(this->bench["low_o"].value(), 0xfedcba98u) << "bit 31 is no sign";
  this->add(~std::uint64_t{0}, 1);
  EXPECT_EQ(this->bench["sum_o"].value(), 0u);
}

class WideLockstep : public testing::Test {
 protected:
  explicit WideLockstep(const std::string& file = plugin())
      : lockstep("lockstep", "wide_sum", model, {}, file) {
    bench.between_edges([this] {
      traffic.next();
      high |= bench["a_i"].value();
    });
  }

  wide_sum model{"model"};
  Lockstep lockstep;
  UnitBench bench{model, &lockstep.clk_i};
  RandomTraffic traffic{bench, LegalInputs({}), 3};
  std::uint64_t high = 0;  // bits of a that were seen
};

TEST_F(WideLockstep, AgreesOnTrafficOfAllBits) {
  bench.clock(5000);
  EXPECT_EQ(lockstep.differences(), 0u);
  EXPECT_EQ(high, ~std::uint64_t{0});
}

TEST_F(WideLockstep, TellsEveryInvertedBit) {
  for (const auto& [port, bits] : {std::pair{"sum_o", 64}, {"least_o", 33}, {"low_o", 32}})
    for (int bit = 0; bit < bits; ++bit) {
      lockstep.invert(port, bit, lockstep.clocks() + 20);
      bench.clock(40);
      ASSERT_TRUE(lockstep.first()) << port << " bit " << bit;
      EXPECT_EQ(lockstep.first()->expected ^ lockstep.first()->got, std::uint64_t{1} << bit);
    }
}

struct WrongInTheTopBit : WideLockstep {
  WrongInTheTopBit()
      : WideLockstep(plugin("a_i + 64'(b_i)", "(a_i + 64'(b_i)) & ~(64'd1 << 63)")) {}
};

TEST_F(WrongInTheTopBit, IsToldWithAllDigits) {
  bench.clock(5000);
  ASSERT_TRUE(lockstep.first());
  const LockstepDifference& first = *lockstep.first();
  EXPECT_EQ(first.expected ^ first.got, TopBit);
  const std::string text = explain(first, {"of random traffic", "repeat", "", "", "default"});
  EXPECT_THAT(text, testing::HasSubstr(fmt::format("{:x}", first.expected)));
  EXPECT_THAT(text, testing::HasSubstr("bit 63"));
}

}  // namespace
}  // namespace racebeam
