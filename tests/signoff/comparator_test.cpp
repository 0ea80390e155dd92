// The comparator's self-test finds a bit that is not compared, and one that is told wrongly.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/comparator.h"

#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "sc/base/engine.h"
#include "sc/swap/rtl_library.h"
#include "tb/scene/engines.h"

namespace racebeam {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::vector<ComparedPort> Outputs = {{"a_o", 3}, {"b_o", 1}};

/// A comparison that finds everything where it is.
ComparatorAnswer sees(const std::string& port, int bit, std::uint64_t& clock) {
  clock = 77;
  return {port, clock, 5, 5 ^ (std::uint64_t{1} << bit)};
}

TEST(Comparator, OneThatSeesEveryBitIsGood) {
  EXPECT_THAT(comparator_faults(Outputs, sees), IsEmpty());
}

TEST(Comparator, ABitThatIsIgnoredIsNamed) {
  const auto ignores = [](const std::string& port, int bit, std::uint64_t& clock) {
    return port == "a_o" && bit == 2 ? ComparatorAnswer{} : sees(port, bit, clock);
  };
  EXPECT_THAT(comparator_faults(Outputs, ignores),
              ElementsAre("a_o[2] is not compared: its inversion is not seen"));
}

TEST(Comparator, ADifferenceAtAnotherPortClockOrBitIsNamed) {
  const auto late = [](const std::string& port, int bit, std::uint64_t& clock) {
    ComparatorAnswer answer = sees(port, bit, clock);
    if (bit == 0) ++answer.clock;
    if (bit == 1) answer.port = "c_o";
    if (bit == 2) answer.got ^= 1;
    return answer;
  };
  EXPECT_THAT(comparator_faults(Outputs, late),
              ElementsAre(HasSubstr("a_o[0] inverted in clock 77 is told as a_o in clock 78"),
                          HasSubstr("a_o[1] inverted in clock 77 is told as c_o"),
                          HasSubstr("a_o[2] inverted"), HasSubstr("b_o[0] inverted")));
}

TEST(Comparator, AnOutputThatTheComparisonDoesNotHaveIsNamedOnce) {
  const auto without = [](const std::string& port, int bit, std::uint64_t& clock) {
    if (port == "a_o") throw RtlError("the RTL has no output a_o");
    return sees(port, bit, clock);
  };
  EXPECT_THAT(comparator_faults(Outputs, without),
              ElementsAre("a_o[0] is not compared: the RTL has no output a_o"));
}

TEST(Comparator, EveryOutputBitOfTheFifoIsComparedTwice) {
  const CheckResult result = sign_off_comparator(
      {"interval_fifo", "", engines().front()->standard(nullptr), nullptr, 12799}, {});
  EXPECT_EQ(result.verdict, CheckResult::Good) << testing::PrintToString(result.faults);
  // ack_o, starving_o, display_o, display_half_o, fill_o
  EXPECT_EQ(result.detail["lockstep"]["bits"], 1 + 1 + 2 + 1 + 7);
  EXPECT_EQ(result.detail["recorded traffic"]["bits"], 12);
}

}  // namespace
}  // namespace racebeam
