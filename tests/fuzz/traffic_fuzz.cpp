// libFuzzer target: no bytes make the reader of port traffic crash. Sums keep most damage from the
// code behind them, so the parts of a file are also given to it with sums that are right.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <xxhash.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "tb/base/errors.h"
#include "tb/base/interrupt.h"
#include "tb/base/leftovers.h"
#include "tb/twin/traffic_codec.h"
#include "tb/twin/traffic_file.h"
#include "tb/twin/traffic_head.h"
#include "tests/fuzz/memory_file.h"

// What SystemC, which the headers want, would start.
int sc_main(int, char**) { std::abort(); }

// What a writer, of which there is none, would ask for.
std::string racebeam::owner_mark() { std::abort(); }
void racebeam::remove_leftovers(const std::string&) { std::abort(); }
bool racebeam::interrupted() { std::abort(); }

namespace {

using namespace racebeam;

/// All of a file that is one.
void read_file(std::string_view bytes) {
  const MemoryFile memory(bytes);
  try {
    TrafficFile file(memory.path());
    std::uint64_t clocks = 0;
    TrafficBlock block;
    while (file.next(block)) {
      check(block.values.size() % file.head().ports.size() == 0 && block.first == clocks);
      if (!block.is_private) clocks += block.values.size() / file.head().ports.size();
    }
    check(clocks == file.clocks());
    for (const TrafficMark& mark : file.marks()) file.seek(mark.clock);
  } catch (const UsageError&) {
  }
}

void read_head(const std::string& text) {
  try {
    const std::string once = head_text(head_of(text));
    check(head_text(head_of(once)) == once);
  } catch (const std::runtime_error&) {
  }
}

/// A block as it is packed, and as what is packed.
void read_block(std::string_view bytes) {
  constexpr std::size_t Ports = 3, Clocks = 50;
  std::vector<std::uint64_t> values, again;
  if (unpack_traffic(bytes, Ports, Clocks, values)) {
    check(values.size() == Ports * Clocks);
    check(unpack_traffic(pack_traffic(values, Ports), Ports, Clocks, again) && again == values);
  }
  values.assign(bytes.size() / Ports * Ports, 0);
  for (std::size_t n = 0; n < values.size(); ++n)
    values[n] = static_cast<unsigned char>(bytes[n]) * 0x0101010101010101ull;
  const std::size_t clocks = values.size() / Ports;
  check(unpack_traffic(pack_traffic(values, Ports), Ports, clocks, again) && again == values);
}

std::string with_sum(std::string bytes) {
  const std::uint64_t sum = XXH64(bytes.data(), bytes.size(), 0);
  return bytes.append(reinterpret_cast<const char*>(&sum), sizeof sum);
}

/// A file whose sums are right: a head, a block and an index of these bytes.
std::string sound(std::string_view bytes) {
  TrafficHead head{"0", "stacks", "beam", "demo", "", "random", {}, {}};
  head.ports = {{"push_en_i", 1, true, false}, {"top_o", 9, false, false}};
  std::string file = with_sum(head_text(head));
  const std::size_t block = bytes.empty() ? 0 : static_cast<unsigned char>(bytes[0]);
  bytes.remove_prefix(std::min<std::size_t>(bytes.size(), 1));
  const std::string packed(bytes.substr(0, block));
  const std::uint64_t sum = XXH64(packed.data(), packed.size(), 0);
  file.append(reinterpret_cast<const char*>(&sum), sizeof sum);
  file += packed;
  const std::uint64_t foot[] = {0x31646e6566617274, file.size()};
  file += with_sum(std::string(bytes.substr(packed.size())));
  return file + with_sum({reinterpret_cast<const char*>(foot), sizeof foot});
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = text_of(data, size);
  read_file(bytes);
  read_head(std::string(bytes));
  read_block(bytes);
  read_file(sound(bytes));
  return 0;
}
