// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/replay_together.h"

#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>

#include "sc/beam/engine.h"
#include "tb/base/errors.h"
#include "tb/base/forked.h"
#include "tb/base/interrupt.h"
#include "tb/bench/beam_core_traffic.h"
#include "tb/bench/chip_traffic.h"
#include "tb/twin/traffic_replay.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;
using Time = std::chrono::steady_clock;

double seconds_since(Time::time_point start) {
  return std::chrono::duration<double>(Time::now() - start).count();
}

/// RTL that is played what comes, up to the first clock in which it differs.
class Playing : public TrafficSink {
 public:
  static constexpr std::size_t BlockClocks = 4096;  // they stay in the second cache

  Playing(const ReplayUnit& unit, const std::function<void(std::uint64_t)>& compared)
      : compared_(compared),
        ports_(unit.head->ports.size()),
        player_(play_rtl(unit.what->dut, *unit.head)) {}

  void add(const std::uint64_t* row, bool is_private) override {
    if (is_private != block_.is_private || block_.values.size() == BlockClocks * ports_) flush();
    if (block_.values.empty()) {
      block_.first = clocks_;
      block_.is_private = is_private;
    }
    block_.values.insert(block_.values.end(), row, row + ports_);
    clocks_ += !is_private;
  }
  void mark(std::int64_t) override {}
  void flush() {
    if (!block_.values.empty()) take(block_);
    block_.values.clear();
  }
  void take(const TrafficBlock& block) {
    if (!agrees_) return;
    const auto start = Time::now();
    try {
      agrees_ = !play(block, *player_);
    } catch (const RtlFault&) {
      agrees_ = false;
    }
    seconds_ += seconds_since(start);
    if (!agrees_ || block.is_private) return;
    const std::uint64_t clocks = block.values.size() / ports_;
    done_ += clocks;
    compared_(clocks);
  }
  bool agrees() const { return agrees_; }
  std::uint64_t done() const { return done_; }
  double seconds() const { return seconds_; }

 private:
  const std::function<void(std::uint64_t)>& compared_;
  const std::size_t ports_;
  const std::unique_ptr<TrafficPlayer> player_;
  TrafficBlock block_;
  bool agrees_ = true;
  std::uint64_t clocks_ = 0, done_ = 0;
  double seconds_ = 0;
};

using Players = std::vector<std::unique_ptr<Playing>>;

void play_cores(const std::vector<ReplayUnit>& units, const ReplayPart& part,
                const Players& players) {
  std::vector<TrafficHead> heads;
  for (const ReplayUnit& unit : units) heads.push_back(*unit.head);
  const Run& run = units.front().what->run;
  BeamCorePass pass(std::move(heads), run.k, run.show.program(), part.first, part.frames);
  for (std::vector<TrafficBlock> blocks; pass.next(blocks);) {
    if (interrupted()) throw Interrupted();
    for (std::size_t n = 0; n < players.size(); ++n) players[n]->take(blocks[n]);
  }
}

void play_chip(const std::vector<ReplayUnit>& units, const ReplayPart& part,
               const Players& players) {
  std::vector<std::string> names;
  for (const ReplayUnit& unit : units) names.push_back(unit.what->dut.unit);
  const Run& run = units.front().what->run;
  std::vector<int> frames(static_cast<std::size_t>(part.frames));
  std::iota(frames.begin(), frames.end(), part.first);
  record_chip_traffic(
      {run.show.engine(), run.k, run.show.tables(), run.show.frames()}, names, frames,
      [&](std::size_t n, const auto&) -> TrafficSink& { return *players[n]; },
      [](int, std::uint64_t) {});
  for (const auto& player : players) player->flush();
}

/// By unit: clocks and seconds, or null.
Json played(const std::vector<ReplayUnit>& units, const ReplayPart& part,
            const std::function<void(std::uint64_t)>& compared) {
  const auto start = Time::now();
  Players players;
  for (const ReplayUnit& unit : units) players.push_back(std::make_unique<Playing>(unit, compared));
  if (&units.front().what->run.show.engine() == &beam_engine()) play_cores(units, part, players);
  else play_chip(units, part, players);
  double share = seconds_since(start);
  for (const auto& player : players) share -= player->seconds();
  share /= static_cast<double>(players.size());
  Json all = Json::array();
  for (const auto& player : players)
    all.push_back(player->agrees()
                      ? Json{{"clocks", player->done()}, {"seconds", player->seconds() + share}}
                      : Json());
  return all;
}

}  // namespace

std::vector<std::optional<UnitVerdict>> replayed_together(
    const std::vector<ReplayUnit>& units, const ReplayPart& part,
    const std::function<void(std::uint64_t)>& compared) {
  std::vector<std::optional<UnitVerdict>> verdicts(units.size());
  std::vector<ReplayUnit> some;
  std::vector<std::size_t> numbers;  // of these
  for (std::size_t n = 0; n < units.size(); ++n)
    if (units[n].what->dut.plugin != ModelPlayer) {
      some.push_back(units[n]);
      numbers.push_back(n);
    }
  if (some.empty()) return verdicts;
  try {
    const Json all = Json::parse(forked([&] { return played(some, part, compared).dump(); }));
    for (std::size_t n = 0; n < some.size(); ++n) {
      if (all[n].is_null()) continue;
      UnitVerdict verdict{some[n].what->dut.unit,
                          some[n].what->traffic,
                          all[n]["clocks"],
                          0,
                          0,
                          all[n]["seconds"],
                          {},
                          {}};
      for (const PortTraffic::Port& port : some[n].head->ports) verdict.masked += !port.input;
      verdicts[numbers[n]] = verdict;
    }
  } catch (const ChildDied&) {  // alone each says how
  }
  return verdicts;
}

}  // namespace racebeam
