// libFuzzer target: no text makes a condition of --when crash or hang, and one that is accepted is
// either true or false in a clock, and the same again.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <string>

#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/trace/chip_signals.h"
#include "tb/trace/condition.h"
#include "tests/fuzz/stand_in_engines.h"

// What SystemC, which the headers want, would start.
int sc_main(int, char**) { std::abort(); }

// What it would say of a name that is not whole.
void racebeam::tell(std::string_view) {}

namespace racebeam {

// Of a chip of five signals.
const std::vector<std::string>* state_words(const ChipSignal& signal) {
  static const std::vector<std::string> words = {"idle", "bisect", "walk", "send"};
  return signal.name == "state_q" ? &words : nullptr;
}

const ChipSignal& example_of(const std::vector<ChipSignal>& signals) { return signals.front(); }

namespace {

std::vector<ChipSignal> few_signals() {
  static std::uint64_t value = 0;
  const auto read = [] { return value += 0x123456789abcdef; };
  return {{"chip.u_subdivider", "state_q", 2, {}, [] { return std::uint64_t{1}; }},
          {"chip.u_subdivider", "sd_q", 4, {}, read},
          {"chip.u_stacks", "x_q", 64, {}, read},
          {"chip.u_stacks", "sd_q", 4, {}, read},
          {"chip.g_core[0].u_lane", "dx_q", 9, {}, [] { return std::uint64_t{0x1ff}; }}};
}

}  // namespace

}  // namespace racebeam

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace racebeam;
  static const TraceAxis of_beam, of_pictures(Raster(), false);
  const std::string text(text_of(data, size));
  for (const TraceAxis* axis : {&of_beam, &of_pictures}) try {
      Condition condition(text, few_signals(), *axis);
      (void)condition.holds(0);
      (void)condition.holds(123'456'789);
    } catch (const UsageError& error) {
      check(std::string(error.what()).rfind("--when", 0) == 0);
    }
  return 0;
}
