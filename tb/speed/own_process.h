// Google Benchmark in a process of its own for each simulation, as SystemC elaborates once.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <benchmark/benchmark.h>

#include <functional>
#include <nlohmann/json_fwd.hpp>

namespace racebeam {

/// One iteration, `repeats` times, in real time.
benchmark::internal::Benchmark* set_up(benchmark::internal::Benchmark* b, int repeats);
/// The same by the processor time of its one thread, which others on the machine change less.
benchmark::internal::Benchmark* set_up_alone(benchmark::internal::Benchmark* b, int repeats);

/// Runs what `prepare` registers and returns Google Benchmark's rows. `row_done` is called in the
/// child after each of them. Throws std::runtime_error with what an exception in the child said.
nlohmann::json run_apart(const std::function<void()>& prepare,
                         const std::function<void()>& row_done);

}  // namespace racebeam
