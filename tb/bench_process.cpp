// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench_process.h"

#include <sstream>

#include "tb/forked.h"

namespace racebeam {

benchmark::internal::Benchmark* set_up(benchmark::internal::Benchmark* b, int repeats) {
  return b->Iterations(1)->Repetitions(repeats)->UseRealTime()->Unit(benchmark::kMillisecond);
}

nlohmann::json run_apart(const std::function<void()>& prepare) {
  const std::string text = forked([&] {
    prepare();
    std::ostringstream out;
    benchmark::JSONReporter reporter;
    reporter.SetOutputStream(&out);
    reporter.SetErrorStream(&out);
    benchmark::RunSpecifiedBenchmarks(&reporter);
    return out.str();
  });
  return nlohmann::json::parse(text).at("benchmarks");
}

}  // namespace racebeam
