// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/speed/program_run.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <stdexcept>

#include "tb/base/child.h"
#include "tb/base/errors.h"

namespace racebeam {

namespace {

double seconds(const timeval& time) { return double(time.tv_sec) + 1e-6 * double(time.tv_usec); }

[[noreturn]] void become(const std::vector<std::string>& words, int out) {
  std::string program = "racebeam";
  std::vector<std::string> all = words;
  std::vector<char*> list = {program.data()};
  for (std::string& word : all) list.push_back(word.data());
  list.push_back(nullptr);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  dup2(out, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  execv("/proc/self/exe", list.data());
  _exit(127);
}

}  // namespace

ProgramRun run_program(const std::vector<std::string>& words) {
  const auto begin = std::chrono::steady_clock::now();
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe to a run of the program");
  const pid_t child = fork_child();
  if (child < 0) throw std::runtime_error("no process for a run of the program");
  if (child == 0) become(words, ends[1]);
  close(ends[1]);
  ProgramRun run;
  char buffer[4096];
  for (ssize_t got; (got = read(ends[0], buffer, sizeof buffer)) != 0;)
    if (got > 0) run.out.append(buffer, static_cast<std::size_t>(got));
    else if (errno != EINTR) break;
  close(ends[0]);
  int status = 0;
  rusage usage{};
  while (wait4(child, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  if (WIFEXITED(status) && WEXITSTATUS(status) == ExitInterrupted) throw Interrupted();
  if (status != 0)
    throw std::runtime_error(death_of(fmt::format("racebeam {}", fmt::join(words, " ")), status));
  run.seconds = took.count();
  run.cpu_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  run.megabytes = double(usage.ru_maxrss) / 1024;
  return run;
}

}  // namespace racebeam
