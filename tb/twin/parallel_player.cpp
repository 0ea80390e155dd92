// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/parallel_player.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "sc/swap/rtl_library.h"

namespace racebeam {

namespace {

/// Bit 0 of each of eight bytes, as one byte; the first byte's is the lowest.
std::uint64_t low_bits(const std::uint8_t* bytes, int bit) {
  constexpr std::uint64_t Low = 0x0101010101010101, Gather = 0x0102040810204080;
  std::uint64_t eight = 0;
  std::memcpy(&eight, bytes, sizeof eight);
  return ((eight >> bit & Low) * Gather) >> 56;
}

template <class Raw>
void gather(const ParallelPlayer::Rows& rows, std::size_t offset, std::uint64_t* values) {
  for (const char* row : rows) {
    Raw raw;
    std::memcpy(&raw, row + offset, sizeof raw);
    *values++ = raw;
  }
}

}  // namespace

ParallelPlayer::ParallelPlayer(const std::string& netlist,
                               const std::vector<PortTraffic::Port>& ports)
    : row_(ports), gates_(netlist) {
  for (std::size_t n = 0; n < ports.size(); ++n) {
    const PortTraffic::Port& port = ports[n];
    const auto found = gates_.ports().find(port.name);
    if (found == gates_.ports().end() && port.optional) continue;
    if (found == gates_.ports().end() || found->second.input != port.input ||
        found->second.nets.size() != static_cast<std::size_t>(port.bits))
      throw RtlError(fmt::format("the netlist has no port {} of {} bits", port.name, port.bits));
    const PackedRow::Field& field = row_.fields()[n];
    (port.input ? inputs_ : outputs_)
        .push_back({field.offset, field.bytes, found->second.nets, {}, {}});
  }
  for (auto* side : {&inputs_, &outputs_})
    for (Bits& port : *side) port.words.resize(port.nets.size());
}

// Turns 64 numbers into words of one bit each, if any of them has moved.
bool ParallelPlayer::take(Bits& port, const Rows& rows) {
  std::array<std::uint64_t, Instances> now;
  switch (port.bytes) {
    case 1: gather<std::uint8_t>(rows, port.offset, now.data()); break;
    case 2: gather<std::uint16_t>(rows, port.offset, now.data()); break;
    case 4: gather<std::uint32_t>(rows, port.offset, now.data()); break;
    default: gather<std::uint64_t>(rows, port.offset, now.data());
  }
  if (now == port.last) return false;
  port.last = now;
  for (std::size_t byte = 0; byte < port.bytes; ++byte) {
    std::array<std::uint8_t, Instances> plane;
    for (std::size_t n = 0; n < Instances; ++n)
      plane[n] = static_cast<std::uint8_t>(now[n] >> 8 * byte);
    for (std::size_t bit = 8 * byte; bit < std::min(8 * byte + 8, port.words.size()); ++bit) {
      Word word = 0;
      for (std::size_t eight = 0; eight < Instances; eight += 8)
        word |= low_bits(plane.data() + eight, static_cast<int>(bit % 8)) << eight;
      port.words[bit] = word;
    }
  }
  return true;
}

ParallelPlayer::Word ParallelPlayer::clock(const Rows& rows, Word compared) {
  for (Bits& port : inputs_) {
    if (!take(port, rows)) continue;
    for (std::size_t bit = 0; bit < port.nets.size(); ++bit)
      gates_.net(port.nets[bit]) = port.words[bit];
  }
  gates_.settle();
  Word other = 0;
  for (Bits& port : outputs_) {
    take(port, rows);
    for (std::size_t bit = 0; bit < port.nets.size(); ++bit)
      other |= gates_.net(port.nets[bit]) ^ port.words[bit];
  }
  gates_.edge();
  return other & compared;
}

}  // namespace racebeam
