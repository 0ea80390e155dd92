// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/replay_together.h"

#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>

#include "tb/base/errors.h"
#include "tb/base/forked.h"
#include "tb/twin/traffic_replay.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;
using Time = std::chrono::steady_clock;

double seconds_since(Time::time_point start) {
  return std::chrono::duration<double>(Time::now() - start).count();
}

/// RTL that is played what comes, up to the first clock in which it differs.
class Playing : public BlockSink {
 public:
  Playing(const ReplayUnit& unit, const std::function<void(std::uint64_t)>& compared)
      : BlockSink(unit.head->ports.size()),
        compared_(compared),
        player_(play_rtl(unit.what->dut, *unit.head)) {}

  void take(const TrafficBlock& block) override {
    if (!agrees_) return;
    const auto start = Time::now();
    try {
      agrees_ = !play(block, *player_);
    } catch (const RtlFault&) {
      agrees_ = false;
    }
    seconds_ += seconds_since(start);
    if (!agrees_ || block.is_private) return;
    const std::uint64_t clocks = block.values.size() / ports();
    done_ += clocks;
    compared_(clocks);
  }
  bool agrees() const { return agrees_; }
  std::uint64_t done() const { return done_; }
  double seconds() const { return seconds_; }

 private:
  const std::function<void(std::uint64_t)>& compared_;
  const std::unique_ptr<TrafficPlayer> player_;
  bool agrees_ = true;
  std::uint64_t done_ = 0;
  double seconds_ = 0;
};

/// By unit: clocks and seconds, or null.
Json played(const std::vector<ReplayUnit>& units, const ReplayPart& part,
            const std::function<void(std::uint64_t)>& compared) {
  const auto start = Time::now();
  std::vector<std::unique_ptr<Playing>> players;
  std::vector<BlockSink*> sinks;
  for (const ReplayUnit& unit : units) {
    players.push_back(std::make_unique<Playing>(unit, compared));
    sinks.push_back(players.back().get());
  }
  make_traffic(units, part, sinks);
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
