// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/bare_rtl.h"

#include <fmt/format.h>

#include <cstring>
#include <random>
#include <type_traits>

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

BareRtl::BareRtl(const std::string& plugin, const PortTraffic& traffic)
    : BareRtl(plugin, traffic.ports) {}

BareRtl::BareRtl(const std::string& plugin, const std::vector<PortTraffic::Port>& ports)
    : library_(plugin), ports_(ports.size()) {
  for (std::size_t n = 0; n < ports.size(); ++n) {
    const PortTraffic::Port& port = ports[n];
    if (port.optional && !has_rtl_port(model(), port.name)) continue;
    const rtl_port& rtl = rtl_port_of(model(), port.name);
    if (rtl.bits != port.bits || (rtl.is_input != 0) != port.input)
      throw RtlError(fmt::format(
          "{}: port {} is {} bits of {} instead of {} bits of {}", rtl_place(model()), port.name,
          rtl.bits, rtl.is_input ? "input" : "output", port.bits, port.input ? "input" : "output"));
    (port.input ? inputs_ : outputs_).push_back({n, &rtl});
    each_size([&](auto& alike) {
      using Raw = std::remove_pointer_t<decltype(alike.inputs[0].data)>;
      if (rtl.bytes != sizeof(Raw)) return;
      (port.input ? alike.inputs : alike.outputs).push_back({n, static_cast<Raw*>(rtl.data)});
    });
  }
}

void BareRtl::hold(const std::string& input, std::uint64_t value) {
  write(rtl_port_of(model(), input), value);
  settled_ = false;
}

// Whether an input has moved.
bool BareRtl::put(const std::uint64_t* row) {
  bool moved = false;
  each_size([&](auto& alike) {
    for (const auto& in : alike.inputs) {
      const auto value = static_cast<std::remove_reference_t<decltype(*in.data)>>(row[in.port]);
      moved |= value != *in.data;
      *in.data = value;
    }
  });
  return moved;
}

bool BareRtl::says(const std::uint64_t* row) {
  bool equal = true;
  each_size([&](auto& alike) {
    for (const auto& out : alike.outputs) equal &= *out.data == row[out.port];
  });
  return equal;
}

// After an edge all has settled: RTL whose inputs have not moved needs no evaluation.
void BareRtl::settle(const std::uint64_t* row) {
  if (!put(row) && settled_) return;
  library_.eval();
  settled_ = true;
}

std::uint64_t BareRtl::value(std::size_t port) const {
  for (const auto* side : {&inputs_, &outputs_})
    for (const Joint& joint : *side)
      if (joint.port == port) return read(*joint.rtl);
  return 0;
}

bool BareRtl::has(std::size_t port) const {
  for (const auto* side : {&inputs_, &outputs_})
    for (const Joint& joint : *side)
      if (joint.port == port) return true;
  return false;
}

void BareRtl::deposit(const std::string& signal, std::uint64_t value) {
  for (int n = 0; n < model().door_count; ++n)
    if (signal == model().doors[n].name) {
      settled_ = false;
      *model().knock |= 1u << n;
      return write(model().doors[n], value);
    }
  for (int n = 0; n < model().signal_count; ++n)
    if (signal == model().signals[n].name) {
      settled_ = false;
      return write(model().signals[n], value);
    }
  throw RtlError(rtl_place(model()) + ": there is no signal " + signal);
}

void BareRtl::drive(const std::uint64_t* rows, std::uint64_t clocks) {
  for (; clocks > 0; --clocks, rows += ports_) {
    settle(rows);
    edge();
  }
}

std::optional<TrafficDifference> BareRtl::run(const std::uint64_t* rows, std::uint64_t clocks,
                                              bool compared) {
  for (std::uint64_t clock = 0; clock < clocks; ++clock, rows += ports_) {
    settle(rows);
    if ((clock > 0 || compared) && !says(rows))
      for (const Joint& out : outputs_)
        if (const std::uint64_t got = read(*out.rtl); got != rows[out.port])
          return TrafficDifference{clock, out.port, rows[out.port], got};
    edge();
  }
  return std::nullopt;
}

std::optional<TrafficDifference> BareRtl::run(const PortTraffic& traffic, std::uint64_t from,
                                              std::uint64_t to) {
  if (from >= to) return std::nullopt;
  auto found = run(traffic.row(from), to - from, begun_);
  if (found) found->clock += from;
  return found;
}

void BareRtl::power_up(std::uint32_t seed) {
  const rtl_model& model = library_.model();
  if (model.signal_count == 0)
    throw RtlError(rtl_place(model) + ": this was built without its signals; give its source");
  library_.eval();
  settled_ = false;
  std::mt19937_64 random(seed);
  for (int n = 0; n < model.signal_count; ++n)
    if (model.signals[n].bits <= 64)
      write(model.signals[n], seed == 0 ? ~std::uint64_t{0} : random());
}

PortTraffic BareRtl::answers(const PortTraffic& traffic,
                             const std::map<std::uint64_t, int>& seeks) {
  PortTraffic all = traffic;
  for (std::uint64_t clock = 0; clock < traffic.clocks(); ++clock) {
    if (const auto frame = seeks.find(clock); frame != seeks.end()) {
      hold("rst_ni", 0);
      library_.eval();
      library_.rise();
      hold("rst_ni", 1);
      hold("frame_end_i", 1);
      library_.eval();
      for (int n = 0; n < frame->second; ++n) library_.rise();
    }
    settle(traffic.row(clock));
    for (const Joint& out : outputs_)
      all.values[clock * traffic.ports.size() + out.port] = read(*out.rtl);
    edge();
  }
  return all;
}

}  // namespace racebeam
