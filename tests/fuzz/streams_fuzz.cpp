// libFuzzer target: no text makes the reader of streams crash; values fit their inputs, and the
// text of what it read is read as the same.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <string>

#include "tb/base/errors.h"
#include "tb/twin/port_stream.h"
#include "tests/fuzz/memory_file.h"

// What SystemC, which the headers want, would start.
int sc_main(int, char**) { std::abort(); }

namespace {

using namespace racebeam;

PortStream form() {
  PortStream form;
  form.unit = "stacks";
  form.counts_frames = true;
  form.inputs = {
      {"rst_n_i", 1, 0, 1}, {"push_en_i", 1, -1, 0}, {"sp_i", 3, -1, 2}, {"tag_i", 64, -1, 0}};
  return form;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const MemoryFile file(text_of(data, size));
  try {
    const PortStream stream = read_stream(file.path(), form());
    check(unit_of_stream(file.path()) == stream.unit && stream.clocks() > 1);
    for (std::uint64_t clock = 0; clock < stream.clocks(); ++clock)
      for (std::size_t n = 0; n < stream.inputs.size(); ++n)
        check(stream.inputs[n].bits == 64 || stream.at(clock, n) >> stream.inputs[n].bits == 0);
    const MemoryFile written(stream_text(stream, {"fuzz"}));
    const PortStream again = read_stream(written.path(), form());
    check(again.values == stream.values && again.seeks == stream.seeks);
  } catch (const UsageError&) {
  }
  return 0;
}
