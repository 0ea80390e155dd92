// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/replay_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "tb/program/replay_parallel.h"
#include "tb/program/replay_source.h"
#include "tb/program/replay_together.h"
#include "tb/twin/parallel_gates.h"

namespace racebeam {

namespace {

constexpr std::size_t LeastInParallel = 8;  // parts

std::vector<ReplayPart> open_parts(const KeptUnit& unit, const std::vector<ReplayPart>& parts) {
  std::vector<ReplayPart> open;
  for (const ReplayPart& part : parts)
    if (!read_part(unit.folder, part, unit.key)) open.push_back(part);
  return open;
}

/// As many parts in each as there are instances, and as many jobs as there are processes.
void split(const ReplayJob& job, std::size_t processes, std::vector<ReplayJob>& jobs) {
  const std::size_t parts = job.parts.size(), most = ParallelGates::Instances;
  const std::size_t count =
      std::max((parts + most - 1) / most, std::min(processes, parts / LeastInParallel));
  for (std::size_t n = 0; n < count; ++n) {
    const auto at = [&](std::size_t i) {
      return job.parts.begin() + static_cast<std::ptrdiff_t>(i * parts / count);
    };
    jobs.push_back({{at(n), at(n + 1)}, job.units, true});
  }
}

UnitVerdict alone(const KeptUnit& unit, const ReplayPart& part,
                  std::atomic<std::uint64_t>& compared) {
  std::string file;
  const auto source = part_source(unit.what, unit.head, part, unit.folder, file);
  std::uint64_t told = 0;
  Replay what = unit.what;
  verilate(what);
  what.captured = fmt::format("--first {} --frames {}", part.first, part.frames);
  what.folder = unit.folder + "/" + std::filesystem::path(part.file()).stem().string();
  const UnitVerdict verdict = replayed(what, *source, [&](std::uint64_t clocks) {
    compared += clocks - told;
    told = clocks;
  });
  if (!file.empty()) std::filesystem::remove(file);
  return verdict;
}

/// Two simulators must agree that the gates differ.
UnitVerdict alone_too(const KeptUnit& unit, const ReplayPart& part,
                      std::atomic<std::uint64_t>& compared) {
  const UnitVerdict verdict = alone(unit, part, compared);
  if (verdict.first || !verdict.fault.empty()) return verdict;
  throw std::runtime_error(fmt::format("gates of {} differ in {} among others, and not alone",
                                       unit.what.dut.unit, part.file()));
}

std::vector<ReplayUnit> units_of(const ReplayJob& job) {
  std::vector<ReplayUnit> units;
  for (const KeptUnit* unit : job.units) units.push_back({&unit->what, &unit->head});
  return units;
}

void do_parallel(const ReplayJob& job, std::atomic<std::uint64_t>& compared) {
  const auto verdicts = replayed_in_parallel(units_of(job), job.parts,
                                             [&](std::uint64_t clocks) { compared += clocks; });
  for (std::size_t n = 0; n < job.parts.size(); ++n)
    for (std::size_t u = 0; u < job.units.size(); ++u) {
      const KeptUnit& unit = *job.units[u];
      const auto& verdict = verdicts[n][u];
      write_part(unit.folder, job.parts[n], unit.key,
                 verdict ? *verdict : alone_too(unit, job.parts[n], compared));
    }
}

}  // namespace

std::vector<ReplayJob> open_jobs(const std::vector<KeptUnit>& units,
                                 const std::vector<ReplayPart>& parts, std::size_t processes) {
  std::map<std::vector<int>, ReplayJob> parallel;  // by the first frames of the parts
  std::map<int, ReplayJob> others;                 // by that of the part
  for (const KeptUnit& unit : units) {
    const std::vector<ReplayPart> open = open_parts(unit, parts);
    std::vector<int> firsts;
    for (const ReplayPart& part : open) firsts.push_back(part.first);
    if (!unit.what.gates.empty() && open.size() >= LeastInParallel) {
      ReplayJob& job = parallel[firsts];
      job.parts = open;
      job.units.push_back(&unit);
      continue;
    }
    for (const ReplayPart& part : open) {
      ReplayJob& job = others[part.first];
      job.parts = {part};
      job.units.push_back(&unit);
    }
  }
  std::vector<ReplayJob> jobs;
  for (const auto& [firsts, job] : parallel) split(job, processes, jobs);
  for (const auto& [first, job] : others) jobs.push_back(job);
  return jobs;
}

// The units that say what the model says share the traffic; each other one tells how it differs.
void do_job(const ReplayJob& job, std::atomic<std::uint64_t>& compared) {
  if (job.in_parallel) return do_parallel(job, compared);
  const ReplayPart& part = job.parts.front();
  const auto verdicts =
      replayed_together(units_of(job), part, [&](std::uint64_t clocks) { compared += clocks; });
  for (std::size_t n = 0; n < job.units.size(); ++n) {
    const KeptUnit& unit = *job.units[n];
    write_part(unit.folder, part, unit.key,
               verdicts[n] ? *verdicts[n] : alone(unit, part, compared));
  }
}

}  // namespace racebeam
