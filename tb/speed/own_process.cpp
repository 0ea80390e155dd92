// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/speed/own_process.h"

#include <nlohmann/json.hpp>
#include <sstream>

#include "tb/base/forked.h"

namespace racebeam {

benchmark::internal::Benchmark* set_up(benchmark::internal::Benchmark* b, int repeats) {
  return set_up_alone(b, repeats)->UseRealTime();
}

benchmark::internal::Benchmark* set_up_alone(benchmark::internal::Benchmark* b, int repeats) {
  return b->Iterations(1)->Repetitions(repeats)->Unit(benchmark::kMillisecond);
}

namespace {

/// Google Benchmark tells of a row's runs, and then of what it makes of them.
class RowReporter : public benchmark::JSONReporter {
 public:
  explicit RowReporter(const std::function<void()>& row_done) : row_done_(row_done) {}
  void ReportRuns(const std::vector<Run>& runs) override {
    JSONReporter::ReportRuns(runs);
    if (!runs.empty() && runs.front().run_type == Run::RT_Iteration) row_done_();
  }

 private:
  const std::function<void()>& row_done_;
};

}  // namespace

nlohmann::json run_apart(const std::function<void()>& prepare,
                         const std::function<void()>& row_done) {
  const std::string text = forked([&] {
    prepare();
    std::ostringstream out;
    RowReporter reporter(row_done);
    reporter.SetOutputStream(&out);
    reporter.SetErrorStream(&out);
    benchmark::RunSpecifiedBenchmarks(&reporter);
    return out.str();
  });
  return nlohmann::json::parse(text).at("benchmarks");
}

}  // namespace racebeam
