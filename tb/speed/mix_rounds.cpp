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

/// Of one mix, with its ratios to what was run beside it.
struct Runs {
  std::vector<double> rates, evaluations, of_models, of_top;

  double add(const nlohmann::json& run) {
    rates.push_back(run.at("clocks").get<double>());
    evaluations.push_back(run.value("evaluations", 0.0));
    return rates.back();
  }
};

/// Two mixes, all models among them, run beside the same runs.
std::size_t pairs_of(const std::vector<ChipMix>& mixes) { return (mixes.size() + 1) / 2; }

}  // namespace

int mix_runs(const std::vector<ChipMix>& mixes, bool with_top, const Effort& effort) {
  const std::size_t beside = pairs_of(mixes) * (with_top ? 2 : 1);
  return static_cast<int>(mixes.size() - 1 + beside) * effort.repeats;
}

std::vector<MixRow> measure_mixes(const std::vector<ChipMix>& mixes, bool with_top,
                                  const Effort& effort, const std::function<void()>& run_done) {
  const std::size_t count = mixes.size();
  const auto once = [&](const std::function<void()>& prepare) {
    const auto rows = run_apart(prepare, [] {});
    run_done();
    return rows.at(0);
  };
  Runs top;
  std::vector<Runs> runs(count);
  const auto run = [&](std::size_t n) {
    return runs[n].add(once([&] { register_mix(mixes[n], {effort.frames, 1}); }));
  };
  for (int round = 0; round < effort.repeats; ++round)
    for (std::size_t pair = 0; pair < pairs_of(mixes); ++pair) {
      const std::size_t before = 2 * pair, after = before + 1;
      if (before > 0) run(before);
      const double models = run(0);
      const double bare =
          with_top ? top.add(once([] { register_verilated(BareTop, 1, true); })) : 0;
      if (after < count) run(after);
      for (std::size_t n = before; n < std::min(after + 1, count); ++n) {
        runs[n].of_models.push_back(n == 0 ? 1 : runs[n].rates.back() / models);
        if (with_top) runs[n].of_top.push_back(runs[n].rates.back() / bare);
      }
    }
  std::vector<MixRow> rows;
  if (with_top) rows.push_back({BareTop, median(top.rates), 0, 1, 0});
  for (std::size_t n = 0; n < count; ++n)
    rows.push_back({"mix: " + mixes[n].name, median(runs[n].rates), median(runs[n].of_models),
                    with_top ? median(runs[n].of_top) : 0, median(runs[n].evaluations)});
  return rows;
}

}  // namespace racebeam
