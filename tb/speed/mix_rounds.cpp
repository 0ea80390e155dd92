// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/speed/mix_rounds.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tb/speed/own_process.h"

namespace racebeam {

namespace {

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 != 0 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

/// Of one row, by round.
struct Runs {
  std::vector<double> rates, evaluations;

  void add(const nlohmann::json& run) {
    rates.push_back(run.at("clocks").get<double>());
    evaluations.push_back(run.value("evaluations", 0.0));
  }
  /// 0 without a base.
  double ratio(const Runs* base) const {
    if (!base) return 0;
    std::vector<double> ratios;
    for (std::size_t round = 0; round < rates.size(); ++round)
      ratios.push_back(rates[round] / base->rates[round]);
    return median(ratios);
  }
};

}  // namespace

std::vector<MixRow> measure_mixes(const std::vector<ChipMix>& mixes, bool with_top,
                                  const Effort& effort, const std::function<void()>& run_done) {
  const auto once = [&](const std::function<void()>& prepare) {
    const auto rows = run_apart(prepare, [] {});
    run_done();
    return rows.at(0);
  };
  Runs top;
  std::vector<Runs> runs(mixes.size());
  for (int round = 0; round < effort.repeats; ++round) {
    if (with_top) top.add(once([] { register_verilated(BareTop, 1, true); }));
    for (std::size_t n = 0; n < mixes.size(); ++n)
      runs[n].add(once([&] { register_mix(mixes[n], {effort.frames, 1}); }));
  }
  std::vector<MixRow> rows;
  if (with_top) rows.push_back({BareTop, median(top.rates), 0, 1, 0});
  for (std::size_t n = 0; n < mixes.size(); ++n)
    rows.push_back({"mix: " + mixes[n].name, median(runs[n].rates), runs[n].ratio(&runs.front()),
                    runs[n].ratio(with_top ? &top : nullptr), median(runs[n].evaluations)});
  return rows;
}

}  // namespace racebeam
