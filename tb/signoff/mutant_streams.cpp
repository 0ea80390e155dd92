// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/mutant_streams.h"

#include <algorithm>
#include <utility>

#include "sc/swap/rtl_library.h"
#include "tb/signoff/mutant_netlist.h"
#include "tb/twin/bare_rtl.h"

namespace racebeam {

namespace {

constexpr ShrinkEffort Effort{100'000, 20};

}  // namespace

MutantStreams::MutantStreams(std::string plugin, PortTraffic ports, LegalInputs legal)
    : plugin_(std::move(plugin)),
      ports_(std::move(ports)),
      legal_(std::move(legal)),
      form_(stream_of(ports_, legal_)) {}

/// What the netlist without a mistake says, from power-up on.
PortTraffic MutantStreams::answers(const PortStream& stream) const {
  PortTraffic traffic = ports_;
  for (std::uint64_t clock = 0; clock < stream.clocks(); ++clock) {
    std::size_t input = 0;
    for (const PortTraffic::Port& port : ports_.ports)
      traffic.values.push_back(port.input ? stream.at(clock, input++) : 0);
  }
  return BareRtl(plugin_, ports_).answers(traffic);
}

std::optional<StreamDifference> MutantStreams::difference(int mutant,
                                                          const PortTraffic& answers) const {
  BareRtl rtl(plugin_, ports_);
  rtl.hold(MutantInput, static_cast<std::uint64_t>(mutant));
  try {
    if (const auto found = rtl.run(answers, 0, answers.clocks()))
      return StreamDifference{found->clock, ports_.ports[found->port].name, found->expected,
                              found->got};
  } catch (const RtlFault&) {  // another way of being found, which no stream is made of
  }
  return std::nullopt;
}

std::optional<StreamDifference> MutantStreams::difference(int mutant,
                                                          const PortStream& stream) const {
  return difference(mutant, answers(stream));
}

std::optional<ShrunkStream> MutantStreams::smallest(
    int mutant, const std::vector<std::vector<std::uint64_t>>& rows) const {
  PortStream whole = form_;
  whole.values.resize(form_.inputs.size());  // the clock in reset that begins each stream
  whole.begin_in_reset();
  for (const auto& row : rows) whole.values.insert(whole.values.end(), row.begin(), row.end());
  const auto found = difference(mutant, whole);
  if (!found) return std::nullopt;
  whole.cut(found->clock + 1);
  return shrink(
      whole, found->port, legal_,
      [&](const std::string& port, std::size_t count,
          const Streams& streams) -> std::optional<StreamHit> {
        for (std::size_t number = 0; number < count; ++number) {
          const PortStream stream = streams(number);
          if (stream.clocks() < 2) continue;
          const auto differs = difference(mutant, stream);
          if (differs && differs->port == port) return StreamHit{number, *differs};
        }
        return std::nullopt;
      },
      Effort);
}

std::vector<std::size_t> covering_streams(const MutantStreams& streams,
                                          const std::vector<EscapedMutant>& escaped) {
  std::vector<std::vector<bool>> finds;
  for (const EscapedMutant& one : escaped) {
    std::vector<bool> row;
    for (const EscapedMutant& other : escaped)
      row.push_back(streams.difference(other.number, one.stream).has_value());
    finds.push_back(std::move(row));
  }
  std::vector<bool> covered(escaped.size());
  const auto gain = [&](std::size_t n) {
    std::size_t count = 0;
    for (std::size_t other = 0; other < escaped.size(); ++other)
      count += finds[n][other] && !covered[other];
    return count;
  };
  std::vector<std::size_t> chosen;
  for (;;) {
    std::size_t best = 0, most = 0;
    for (std::size_t n = 0; n < escaped.size(); ++n) {
      const std::size_t count = gain(n);
      if (count < most || count == 0) continue;
      if (count > most || escaped[n].stream.clocks() < escaped[best].stream.clocks()) best = n;
      most = count;
    }
    if (most == 0) return chosen;
    chosen.push_back(best);
    for (std::size_t other = 0; other < escaped.size(); ++other)
      if (finds[best][other]) covered[other] = true;
  }
}

}  // namespace racebeam
