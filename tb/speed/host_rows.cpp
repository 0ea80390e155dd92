// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/speed/host_rows.h"

#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>

#include <stdexcept>

#include "tb/base/child.h"
#include "tb/base/spread_frames.h"
#include "tb/bench/tlm_bench.h"
#include "tb/picture/png_file.h"
#include "tb/speed/own_process.h"

namespace racebeam {

namespace {

/// Seconds for each of `count` things that an iteration does.
benchmark::Counter seconds_each(int count) {
  return benchmark::Counter(count, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void run_version() {
  char program[] = "/proc/self/exe", option[] = "--version";
  char* const words[] = {program, option, nullptr};
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t child = -1;
  const int error = posix_spawn(&child, program, &files, nullptr, words, environ);
  posix_spawn_file_actions_destroy(&files);
  if (error != 0 || wait_for_child(child) != 0)
    throw std::runtime_error("racebeam --version does not run");
}

}  // namespace

void register_start(int repeats) {
  set_up(benchmark::RegisterBenchmark("host: start",
                                      [](benchmark::State& state) {
                                        for (auto _ : state) run_version();
                                        state.counters["seconds"] = seconds_each(1);
                                      }),
         repeats);
}

void register_png(const Effort& effort) {
  auto pictures = std::make_shared<std::vector<VgaFrame>>();
  TlmBench bench(TlmBench::Options{});
  for (const int frame : spread_frames(DemoFrames, effort.frames)) {
    bench.seek(frame);
    pictures->push_back(bench.render().picture);
  }
  set_up(benchmark::RegisterBenchmark("host: PNG of a frame",
                                      [pictures](benchmark::State& state) {
                                        for (auto _ : state)
                                          for (const VgaFrame& picture : *pictures)
                                            benchmark::DoNotOptimize(png_bytes(
                                                picture.colours, picture.width, picture.height));
                                        state.counters["seconds"] =
                                            seconds_each(static_cast<int>(pictures->size()));
                                      }),
         effort.repeats);
}

}  // namespace racebeam
