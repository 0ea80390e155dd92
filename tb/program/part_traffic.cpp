// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/part_traffic.h"

#include <numeric>

#include "sc/beam/engine.h"
#include "tb/base/errors.h"
#include "tb/base/interrupt.h"
#include "tb/bench/beam_core_traffic.h"
#include "tb/bench/chip_traffic.h"

namespace racebeam {

namespace {

void make_by_cores(const std::vector<ReplayUnit>& units, const ReplayPart& part,
                   const std::vector<BlockSink*>& sinks) {
  std::vector<TrafficHead> heads;
  for (const ReplayUnit& unit : units) heads.push_back(*unit.head);
  const Run& run = units.front().what->run;
  BeamCorePass pass(std::move(heads), run.k, run.show.program(), part.first, part.frames);
  for (std::vector<TrafficBlock> blocks; pass.next(blocks);) {
    if (interrupted()) throw Interrupted();
    for (std::size_t n = 0; n < sinks.size(); ++n) sinks[n]->take(blocks[n]);
  }
}

void make_by_chip(const std::vector<ReplayUnit>& units, const ReplayPart& part,
                  const std::vector<BlockSink*>& sinks) {
  std::vector<std::string> names;
  for (const ReplayUnit& unit : units) names.push_back(unit.what->dut.unit);
  const Run& run = units.front().what->run;
  std::vector<int> frames(static_cast<std::size_t>(part.frames));
  std::iota(frames.begin(), frames.end(), part.first);
  record_chip_traffic(
      {run.show.engine(), run.k, run.show.tables(), run.show.frames()}, names, frames,
      [&](std::size_t n, const auto&) -> TrafficSink& { return *sinks[n]; },
      [](int, std::uint64_t) {});
  for (BlockSink* sink : sinks) sink->flush();
}

}  // namespace

void make_traffic(const std::vector<ReplayUnit>& units, const ReplayPart& part,
                  const std::vector<BlockSink*>& sinks) {
  if (&units.front().what->run.show.engine() == &beam_engine()) make_by_cores(units, part, sinks);
  else make_by_chip(units, part, sinks);
}

}  // namespace racebeam
