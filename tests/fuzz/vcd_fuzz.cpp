// libFuzzer target: no text makes the reader of value change dumps crash or hang; what it reads is
// as its header promises, and a dump does not differ from itself.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <sstream>
#include <string>

#include "tb/base/errors.h"
#include "tb/wave/vcd_diff.h"
#include "tb/wave/vcd_reader.h"
#include "tests/fuzz/stand_in_engines.h"

namespace {

using namespace racebeam;

VcdReader opened(const std::string& text) {
  return VcdReader(std::make_unique<std::istringstream>(text), "fuzz");
}

/// Reads all of it.
void read_through(const std::string& text) {
  VcdReader dump = opened(text);
  check(dump.unit() > 0 && dump.paths().size() == dump.signals().size());
  for (const std::string& path : dump.paths()) check(dump.signals().count(path) == 1);
  for (std::optional<std::uint64_t> last; dump.next_time(); last = *last) {
    check(!last || *dump.next_time() > *last);
    last = dump.next_time();
    for (const int signal : dump.advance()) {
      const std::size_t length = dump.value(signal).size();
      const int bits = dump.bits(signal);
      check(bits == 0 || (length > 0 && length <= static_cast<std::size_t>(bits)));
    }
  }
  check(dump.advance().empty());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(text_of(data, size));
  try {
    read_through(text);
    VcdReader a = opened(text), b = opened(text);
    check(compare_vcds(a, b, [](const std::string&) { return true; }).same());
  } catch (const UsageError&) {
  }
  return 0;
}
