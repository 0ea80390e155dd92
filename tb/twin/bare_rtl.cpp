// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/bare_rtl.h"

#include <fmt/format.h>

#include <cstring>

#include "sc/base/unit.h"

namespace racebeam {

namespace {

// The machine's bytes begin with the lowest.
void write(const rtl_port& port, std::uint64_t value) {
  const std::uint64_t raw = raw_bits(value, port.bits);
  std::memcpy(port.data, &raw, static_cast<std::size_t>(port.bytes));
}

std::uint64_t read(const rtl_port& port) {
  std::uint64_t value = 0;
  std::memcpy(&value, port.data, static_cast<std::size_t>(port.bytes));
  return value;
}

}  // namespace

BareRtl::BareRtl(const std::string& plugin, const PortTraffic& traffic) : library_(plugin) {
  for (std::size_t n = 0; n < traffic.ports.size(); ++n) {
    const PortTraffic::Port& port = traffic.ports[n];
    const rtl_port& rtl = rtl_port_of(library_.model(), port.name);
    if (rtl.bits != port.bits || (rtl.is_input != 0) != port.input)
      throw RtlError(fmt::format("{}: port {} is {} bits of {} instead of {} bits of {}",
                                 rtl_place(library_.model()), port.name, rtl.bits,
                                 rtl.is_input ? "input" : "output", port.bits,
                                 port.input ? "input" : "output"));
    (port.input ? inputs_ : outputs_).push_back({n, &rtl});
  }
}

void BareRtl::hold(const std::string& input, std::uint64_t value) {
  write(rtl_port_of(library_.model(), input), value);
}

std::optional<TrafficDifference> BareRtl::run(const PortTraffic& traffic, std::uint64_t from,
                                              std::uint64_t to) {
  for (std::uint64_t clock = from; clock < to; ++clock) {
    const std::uint64_t* row = traffic.row(clock);
    for (const Joint& in : inputs_) write(*in.rtl, row[in.port]);
    library_.eval();
    if (begun_)
      for (const Joint& out : outputs_)
        if (const std::uint64_t got = read(*out.rtl); got != row[out.port])
          return TrafficDifference{clock, out.port, row[out.port], got};
    library_.rise();
    begun_ = true;
  }
  return std::nullopt;
}

}  // namespace racebeam
