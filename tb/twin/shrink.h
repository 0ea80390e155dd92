// A stream in which model and RTL differ, made as small as it gets: few clocks, few inputs that
// move, few changes, small numbers.
//
// Delta debugging (Zeller and Hildebrandt, 2002): what was recorded is cut, first to the last
// clocks, begun in reset, that still fail, then clock by clock, input by input, value by value; a
// cut counts if the same port differs first. The order is fixed, and the effort is counted in
// clocks, not in seconds: the same stream gives the same result everywhere.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "tb/twin/legal_inputs.h"
#include "tb/twin/port_stream.h"

namespace racebeam {

/// The first output that differs when a stream is played from power-up on.
struct StreamDifference {
  std::uint64_t clock = 0;
  std::string port;
  std::uint64_t expected = 0, got = 0;  ///< of the model, and of the RTL
};

/// Streams by their number.
using Streams = std::function<PortStream(std::size_t number)>;

/// One of several streams in which the port differs that is looked for.
struct StreamHit {
  std::size_t number = 0;
  StreamDifference difference;
};

/// Plays streams 0 to `count` (excluded) up to the first in which `port` differs first. It must
/// depend on nothing else, and leave out streams that have no clock after the reset.
using FindStream = std::function<std::optional<StreamHit>(
    const std::string& port, std::size_t count, const Streams& streams)>;

struct ShrunkStream {
  PortStream stream;  ///< its last clock is that of the difference
  StreamDifference difference;
  std::uint64_t plays = 0;  ///< streams that were tried
};

struct ShrinkEffort {
  std::uint64_t clocks = 2'000'000;  ///< played, at most
  std::uint64_t play = 20;           ///< what a play costs beside its clocks, in clocks
};

/// `found` ends with the clock in which `port` differs. Nothing, if that does not differ when its
/// last clocks begin in reset. `legal`: what inputs may be.
std::optional<ShrunkStream> shrink(const PortStream& found, const std::string& port,
                                   const LegalInputs& legal, const FindStream& find,
                                   const ShrinkEffort& effort = {});

}  // namespace racebeam
