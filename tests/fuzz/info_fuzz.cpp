// libFuzzer target: no text makes the reader of Tiny Tapeout's info.yaml crash or hang, nor those
// of the files beside it; what it accepts can be verilated by its names.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>

#include "tb/base/errors.h"
#include "tb/tt/tt_info.h"
#include "tests/fuzz/stand_in_engines.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace racebeam;
  const std::string text(text_of(data, size));
  for (const bool clock_is_known : {false, true}) try {
      const TtInfo info = read_tt_info(text, "fuzz", clock_is_known);
      check(info.top.rfind("tt_um_", 0) == 0 && !info.sources.empty());
      check(info.top.find_first_of("$`;\"' ") == std::string::npos);
      for (const TtInfo::Source& source : info.sources)
        check(!source.name.empty() && source.name.find('\0') == std::string::npos);
      check(info.clock_hz <= 1'000'000'000);
    } catch (const UsageError& error) {
      check(std::string(error.what()).rfind("fuzz", 0) == 0);
    }
  return 0;
}
