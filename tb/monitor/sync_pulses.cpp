// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/monitor/sync_pulses.h"

#include <map>
#include <utility>

namespace racebeam {

namespace {

/// Clocks in which a pin changes, from `from` on, and its level after the last of them.
std::pair<std::vector<std::uint64_t>, bool> edges_of(const std::vector<PinChange>& changes, int pin,
                                                     std::uint64_t from) {
  std::pair<std::vector<std::uint64_t>, bool> edges{{}, false};
  for (const PinChange& change : changes) {
    const bool now = (change.uo >> pin) & 1;
    if (now != edges.second && change.clock >= from) edges.first.push_back(change.clock);
    edges.second = now;
  }
  return edges;
}

/// The pulse of the period that begins at an edge and ends two edges later; `level` is that from
/// its first edge on.
SyncPulse pulse_of(const std::uint64_t* edge, bool level) {
  const std::uint64_t first = edge[1] - edge[0], second = edge[2] - edge[1];
  return first < second ? SyncPulse{edge[0], first + second, first, level}
                        : SyncPulse{edge[1], first + second, second, !level};
}

}  // namespace

std::optional<SyncPulse> last_pulse(const std::vector<PinChange>& changes, int pin,
                                    std::uint64_t from) {
  const auto [edges, level] = edges_of(changes, pin, from);
  if (edges.size() < 3) return {};
  return pulse_of(&edges[edges.size() - 3], level);  // as after its last edge
}

std::optional<SyncPulse> usual_pulse(const std::vector<PinChange>& changes, int pin) {
  const auto [edges, level] = edges_of(changes, pin, 0);
  if (edges.size() < 5) return {};
  std::map<std::pair<std::uint64_t, std::uint64_t>, std::size_t> counts;  // of period and pulse
  std::map<std::pair<std::uint64_t, std::uint64_t>, SyncPulse> last;
  for (std::size_t i = edges.size() % 2; i + 2 < edges.size(); i += 2) {
    const SyncPulse pulse = pulse_of(&edges[i], level == ((edges.size() - 1 - i) % 2 == 0));
    ++counts[{pulse.period, pulse.length}];
    last[{pulse.period, pulse.length}] = pulse;
  }
  auto most = counts.begin();
  for (auto at = counts.begin(); at != counts.end(); ++at)
    if (at->second > most->second) most = at;
  if (most->second * 2 < edges.size() / 2) return {};
  return last[most->first];
}

}  // namespace racebeam
