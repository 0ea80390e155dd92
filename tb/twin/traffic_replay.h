// Recorded traffic goes into whatever has the unit's ports, and its outputs are compared.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "tb/twin/bare_rtl.h"
#include "tb/twin/lockstep.h"
#include "tb/twin/traffic_file.h"
#include "tb/twin/unit_under_test.h"

namespace racebeam {

/// An instance of the unit, from power-up on.
class TrafficPlayer {
 public:
  virtual ~TrafficPlayer() = default;
  /// As those of BareRtl.
  virtual std::optional<TrafficDifference> run(const std::uint64_t* rows, std::uint64_t clocks,
                                               bool compared) = 0;
  virtual void drive(const std::uint64_t* rows, std::uint64_t clocks) = 0;
  /// A value for a register inside; throws RtlError if there is none of this name.
  virtual void deposit(const std::string& signal, std::uint64_t value) = 0;
  virtual void settle(const std::uint64_t* row) = 0;
  virtual void edge() = 0;
  virtual std::uint64_t value(std::size_t port) const = 0;
  virtual bool has(std::size_t port) const = 0;
  virtual std::size_t ports() const = 0;  ///< of the traffic
};

/// RTL, a netlist too. Throws RtlError, also if it is of another unit, has ports that the unit does
/// not have, or was built with other parameters than the knobs of `dut` want.
std::unique_ptr<TrafficPlayer> play_rtl(const UnitUnderTest& dut, const TrafficHead& head);

/// The model on a bench. Only one, and nothing else of SystemC, may be in a process.
std::unique_ptr<TrafficPlayer> play_model(const UnitUnderTest& dut, const TrafficHead& head);

/// Where traffic is.
struct ReplayDone {
  std::uint64_t clocks = 0;  ///< that are not private
  /// The first clock in which an output is not as recorded.
  std::optional<std::uint64_t> difference;
};

/// A block of it, as its kind wants. Throws RtlFault.
std::optional<TrafficDifference> play(const TrafficBlock& block, TrafficPlayer& player);

/// All of the traffic, from its start on up to a difference; `compared` is told now and then how
/// many clocks are done. Throws RtlFault, Interrupted, what the source throws.
ReplayDone replay(TrafficSource& source, TrafficPlayer& player,
                  const std::function<void(std::uint64_t)>& compared);

/// The clocks around a difference that replay() found, by another player of the same.
struct ReplayWindow {
  LockstepDifference first;
  std::uint64_t differences = 0;  ///< clocks in which some output differed, so far
  std::uint64_t clocks = 0;
};
ReplayWindow replay_window(TrafficSource& source, TrafficPlayer& player, std::uint64_t difference);

}  // namespace racebeam
