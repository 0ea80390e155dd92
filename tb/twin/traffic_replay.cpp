// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/traffic_replay.h"

#include <algorithm>

#include "tb/base/errors.h"
#include "tb/base/interrupt.h"

namespace racebeam {

std::optional<TrafficDifference> play(const TrafficBlock& block, TrafficPlayer& player) {
  for (const auto& [signal, value] : block.deposits) player.deposit(signal, value);
  const std::uint64_t clocks = block.values.size() / player.ports();
  if (!block.is_private) return player.run(block.values.data(), clocks, block.first > 0);
  player.drive(block.values.data(), clocks);
  return std::nullopt;
}

ReplayDone replay(TrafficSource& source, TrafficPlayer& player,
                  const std::function<void(std::uint64_t)>& compared) {
  ReplayDone done;
  source.rewind();
  for (TrafficBlock block; source.next(block);) {
    if (interrupted()) throw Interrupted();
    if (const auto found = play(block, player)) {
      done.difference = block.first + found->clock;
      done.clocks = *done.difference + 1;
      return done;
    }
    if (block.is_private) continue;
    done.clocks = block.first + block.values.size() / player.ports();
    compared(done.clocks);
  }
  return done;
}

namespace {

using Side = LockstepDifference::Side;

/// The columns of a difference, and what a clock has in them.
class Rows {
 public:
  Rows(const std::vector<PortTraffic::Port>& ports, const TrafficPlayer& player)
      : ports_(ports), player_(player) {
    for (std::size_t n = 0; n < ports.size(); ++n)
      if (player.has(n)) (ports[n].input ? inputs_ : outputs_).push_back(n);
  }
  std::vector<LockstepDifference::Column> columns() const {
    std::vector<LockstepDifference::Column> all;
    for (const std::size_t n : inputs_)
      all.push_back({ports_[n].name, Side::Input, ports_[n].bits});
    for (const std::size_t n : outputs_)
      for (const Side side : {Side::Model, Side::Rtl})
        all.push_back({ports_[n].name, side, ports_[n].bits});
    return all;
  }
  std::vector<std::uint64_t> now(const std::uint64_t* row) const {
    std::vector<std::uint64_t> values;
    for (const std::size_t n : inputs_) values.push_back(row[n]);
    for (const std::size_t n : outputs_) {
      values.push_back(row[n]);
      values.push_back(player_.value(n));
    }
    return values;
  }
  /// The first output that differs: its number among the outputs, or -1.
  int different(const std::uint64_t* row) const {
    for (std::size_t i = 0; i < outputs_.size(); ++i)
      if (player_.value(outputs_[i]) != row[outputs_[i]]) return static_cast<int>(i);
    return -1;
  }
  std::size_t output(int number) const { return outputs_.at(static_cast<std::size_t>(number)); }

 private:
  const std::vector<PortTraffic::Port>& ports_;
  const TrafficPlayer& player_;
  std::vector<std::size_t> inputs_, outputs_;
};

}  // namespace

ReplayWindow replay_window(TrafficSource& source, TrafficPlayer& player, std::uint64_t difference) {
  const std::vector<PortTraffic::Port>& ports = source.head().ports;
  const Rows rows(ports, player);
  ReplayWindow window;
  LockstepDifference& d = window.first;
  d.unit = source.head().unit;
  d.clock = difference;
  d.columns = rows.columns();
  d.before = std::min<std::uint64_t>(difference, LockstepDifference::Before);
  source.rewind();
  for (TrafficBlock block; !d.whole() && source.next(block);) {
    if (interrupted()) throw Interrupted();
    const std::uint64_t clocks = block.values.size() / ports.size();
    const std::uint64_t* row = block.values.data();
    const std::uint64_t begin = std::max(d.first_clock(), block.first) - block.first;
    for (const auto& [signal, value] : block.deposits) player.deposit(signal, value);
    const std::uint64_t quick = block.is_private ? clocks : std::min(clocks, begin);
    player.drive(row, quick);
    row += quick * ports.size();
    for (std::uint64_t n = quick; n < clocks && !d.whole(); ++n, row += ports.size()) {
      const std::uint64_t clock = block.first + n;
      player.settle(row);
      d.history.push_back(rows.now(row));
      const int output = clock > 0 ? rows.different(row) : -1;
      window.differences += output >= 0;
      window.clocks = clock + 1;
      if (clock == difference && output >= 0) {
        d.output = output;
        d.port = ports[rows.output(output)].name;
        d.expected = row[rows.output(output)];
        d.got = player.value(rows.output(output));
      }
      player.edge();
    }
  }
  return window;
}

}  // namespace racebeam
