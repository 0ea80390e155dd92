// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/run_traffic.h"

#include <fmt/format.h>

#include "tb/base/errors.h"
#include "tb/base/version.h"

namespace racebeam {

TrafficHead traffic_head(const Run& run, const std::string& unit, const std::string& source,
                         const std::vector<PortTraffic::Port>& ports) {
  TrafficHead head{program_version(),
                   unit,
                   run.show.engine().name,
                   run.show.name(),
                   run.show.hash(),
                   source,
                   {},
                   ports};
  for (std::size_t n = 0; n < run.k.rows().size(); ++n)
    head.knobs.emplace_back(run.k.rows()[n].name, run.k[n]);
  return head;
}

void expect_traffic(const std::string& path, const TrafficHead& head, const Run& run,
                    const std::string& unit) {
  const TrafficHead wanted = traffic_head(run, unit, head.source, head.ports);
  const auto refuse = [&](const std::string& what, const std::string& advice) {
    throw UsageError(path + " is traffic of " + what + "; " + advice);
  };
  if (head.unit != unit)
    refuse(fmt::format("{}, not of {}", head.unit, unit), "verify " + head.unit);
  if (head.program != wanted.program)
    refuse(fmt::format("racebeam {}, and this is {}, whose models may differ", head.program,
                       wanted.program),
           "make it again with `racebeam capture`");
  if (head.engine != wanted.engine || head.scene != wanted.scene)
    refuse(fmt::format("the scene {} of {}, not of {}", head.scene, head.engine, wanted.scene),
           "say --scene with that scene");
  if (head.scene_hash != wanted.scene_hash)
    refuse("the scene " + head.scene + ", which is another file now",
           "make it again with `racebeam capture`");
  std::string other;
  for (std::size_t n = 0; n < wanted.knobs.size() && n < head.knobs.size(); ++n)
    if (head.knobs[n] != wanted.knobs[n])
      other += fmt::format(" --set {}={}", head.knobs[n].first,
                           run.k.rows()[n].text(head.knobs[n].second));
  if (!other.empty()) refuse("a chip with other knobs", "say" + other);
  if (head.knobs.size() != wanted.knobs.size())
    refuse("a chip with other knobs", "make it again with `racebeam capture`");
}

// All visits are of whole frames, and begin with the first clock after that in reset.
std::vector<int> frames_of(const std::vector<TrafficMark>& marks, std::uint64_t clocks,
                           const Raster& raster) {
  const auto length = static_cast<std::uint64_t>(raster.frame_clocks());
  std::vector<int> frames;
  for (std::size_t n = 0; n < marks.size(); ++n) {
    const std::uint64_t end = n + 1 < marks.size() ? marks[n + 1].clock : clocks;
    for (std::uint64_t clock = marks[n].clock; clock < end; clock += length)
      frames.push_back(static_cast<int>(marks[n].frame));
  }
  return frames;
}

}  // namespace racebeam
