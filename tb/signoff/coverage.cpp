// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/coverage.h"

#include <chrono>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "sc/swap/rtl_coverage.h"
#include "sc/swap/rtl_library.h"
#include "sc/swap/rtl_parameters.h"
#include "tb/base/errors.h"
#include "tb/base/forked.h"
#include "tb/base/project_folder.h"
#include "tb/scene/engines.h"
#include "tb/signoff/constant_bits.h"
#include "tb/signoff/unit_drive.h"
#include "tb/twin/twins.h"
#include "tb/verilate/cache_folder.h"
#include "tb/verilate/rtl_plugin.h"

namespace racebeam {

namespace {

using Json = nlohmann::json;

RtlSources sources_of(const UnitUnderTest& dut, const std::string& rtl) {
  const PluginMaker maker = twins_of(engine_of(dut.k)).plugins(dut.k, dut.scene, false);
  RtlSources sources = rtl.empty() ? maker.own_rtl(dut.unit) : maker.users_rtl(dut.unit, rtl);
  sources.coverage = true;
  return sources;
}

/// One run in a process of its own; adds to `coverage`.
void add_run(const UnitUnderTest& dut, const std::string& plugin, UnitDrive::Stimulus stimulus,
             std::uint64_t clocks, unsigned seed, UnitCoverage& coverage) {
  const WorkFolder work;
  const std::string counts = work.file("coverage.dat");
  const std::vector<FunctionalCross> crosses = functional_crosses(dut.unit);
  const Json seen = Json::parse(forked([&] {
    UnitDrive drive(dut, plugin, stimulus, seed);
    std::vector<std::unique_ptr<CrossCounter>> counters;
    for (const FunctionalCross& cross : crosses)
      counters.push_back(std::make_unique<CrossCounter>(cross, drive.bench(), drive.model()));
    drive.run(clocks, [&] {
      for (const auto& counter : counters) counter->look();
    });
    if (drive.lockstep().fault()) throw RtlError(*drive.lockstep().fault());
    write_rtl_coverage(plugin, counts);
    Json all = Json::array();
    for (const auto& counter : counters) all.push_back(counter->counts());
    return all.dump();
  }));
  add_coverage(coverage.points, read_coverage(counts));
  coverage.crosses.resize(crosses.size());
  for (std::size_t n = 0; n < crosses.size(); ++n) {
    const auto more = seen[n].get<std::vector<std::uint64_t>>();
    coverage.crosses[n].resize(more.size());
    for (std::size_t i = 0; i < more.size(); ++i) coverage.crosses[n][i] += more[i];
  }
  coverage.clocks += clocks;
}

void find_constant(const UnitUnderTest& dut, RtlSources sources, UnitCoverage& coverage) {
  const RtlSyntax syntax = read_rtl_syntax(sources);
  const ConstantBits constants(
      sources,
      tied_inputs(twins_of(engine_of(dut.k)).inputs(dut.k, dut.scene, dut.unit), syntax.ports));
  for (std::size_t n = 0; n < coverage.points.size(); ++n) {
    const CoveragePoint& point = coverage.points[n];
    const std::string file =
        (std::filesystem::path(project_folder()) / point.file).lexically_normal().string();
    coverage.constant[n] =
        point.kind == CoveragePoint::Toggle && constants.has(file, point.line, point.name);
  }
}

CheckResult undecided(const std::string& unit, const std::string& why) {
  return {unit, "coverage", CheckResult::Undecided, why, {why}, {}, 0};
}

}  // namespace

UnitCoverage measure_coverage(const UnitUnderTest& dut, const CoverageOptions& options) {
  const RtlSources sources = sources_of(dut, options.rtl);
  const std::string plugin = rtl_plugin(sources);
  UnitCoverage coverage;
  if (const UnitWalk* const walk = twins_of(engine_of(dut.k)).walk(dut.unit))
    add_run(dut, plugin, UnitDrive::Walk, walk->clocks, options.seed, coverage);
  if (options.random > 0)
    add_run(dut, plugin, UnitDrive::Random, options.random, options.seed, coverage);
  coverage.constant.resize(coverage.points.size());
  find_constant(dut, sources, coverage);
  for (const rtl_parameter& parameter : engine_of(dut.k).parameters(dut.k))
    coverage.parameters[parameter.name] = parameter.value;
  for (const RtlSyntax::Parameter& parameter : read_rtl_syntax(sources).parameters)
    if (!parameter.value.empty()) coverage.parameters[parameter.name] = std::stoll(parameter.value);
  return coverage;
}

CheckResult sign_off_coverage(const UnitUnderTest& dut, const CoverageOptions& options) {
  const std::vector<CoverageWaiver> waivers = load_coverage_waivers(options.waivers);
  if (std::filesystem::path(options.rtl).extension() == ".so")
    return undecided(dut.unit, options.rtl + " is a plug-in: give its source, which is counted in");
  const auto start = std::chrono::steady_clock::now();
  CheckResult result;
  try {
    result = judge_coverage(dut.unit, measure_coverage(dut, options), functional_crosses(dut.unit),
                            waivers);
  } catch (const MissingTool& missing) {
    return undecided(dut.unit, missing.what());
  } catch (const Interrupted&) {
    return undecided(dut.unit, "interrupted");
  } catch (const RtlError& fault) {
    return {dut.unit, "coverage", CheckResult::Bad, "the RTL does not run", {fault.what()}, {}, 0};
  } catch (const ChildDied& death) {
    return {dut.unit, "coverage", CheckResult::Bad, "the RTL does not run", {death.what()}, {}, 0};
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace racebeam
