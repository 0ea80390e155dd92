// libFuzzer target: no text makes the readers of a config.json and of a Makefile crash or hang,
// and no word of theirs is empty.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>

#include "tb/tt/tt_settings.h"
#include "tests/fuzz/stand_in_engines.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace racebeam;
  std::istringstream config{std::string(text_of(data, size))}, makefile(config.str());
  for (const std::string& define : read_config_json(config, "/nowhere").defines)
    check(!define.empty());
  for (const std::string& define : read_test_defines(makefile)) check(!define.empty());
  return 0;
}
