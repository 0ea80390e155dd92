// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/trace/flight_recorder.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <initializer_list>
#include <utility>

#include "sc/swap/rtl_run.h"
#include "tb/base/child.h"
#include "tb/base/errors.h"
#include "tb/base/guarded.h"
#include "tb/base/interrupt.h"

namespace racebeam {

namespace {

constexpr int NoAnswer = -1;
constexpr int ReplaySeconds = 60;  // after an interrupt
const std::initializer_list<int> Crashes = {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT};
const std::initializer_list<int> Interrupts = {SIGINT, SIGTERM, SIGHUP};

FlightRecorder* crashing = nullptr;  // whose events a signal handler reports

int wait_for(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0)
    if (errno != EINTR) return NoAnswer;
  return WIFEXITED(status) ? WEXITSTATUS(status) : NoAnswer;
}

}  // namespace

FlightRecorder::FlightRecorder(std::int64_t keep, std::function<int(const FlightEvent&)> replay,
                               std::int64_t shortest_step)
    : keep_(keep), step_(std::max(keep + 1, shortest_step)), replay_(std::move(replay)) {}

FlightRecorder::~FlightRecorder() {
  if (crashing == this) crashing = nullptr;
  for (const auto& [number, action] : before_) sigaction(number, &action, nullptr);
  for (const Copy& copy : copies_) dismiss(copy);
}

void FlightRecorder::dismiss(const Copy& copy) {
  close(copy.order);
  wait_for(copy.process);
}

void FlightRecorder::pass(std::int64_t clock) {
  if (!copies_.empty() && clock < copies_.back().clock + step_) return;
  if (!copy(clock) && copies_.empty())
    throw MissingTool("no process for a copy of the run; end other programs, or raise `ulimit -u`");
  if (copies_.size() <= 2) return;
  dismiss(copies_.front());
  copies_.erase(copies_.begin());
}

bool FlightRecorder::copy(std::int64_t clock) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return false;
  const pid_t process = fork_child();
  if (process == 0) {
    close(ends[1]);
    wait_for_event(ends[0]);
  }
  close(ends[0]);
  if (process < 0) close(ends[1]);
  else copies_.push_back({process, ends[1], clock});
  return process > 0;
}

// The life of a copy: it ends without a word if the pipe is closed. It never returns to the
// program, whose threads are not copied, and ends with whoever waits for it.
void FlightRecorder::wait_for_event(int orders) {
  for (const int number : Interrupts) signal(number, SIG_IGN);
  for (const int number : Crashes) signal(number, SIG_DFL);
  for (const Copy& older : copies_) close(older.order);  // or they would not see them closed
  copies_.clear();
  FlightEvent event;
  ssize_t got;
  do got = read(orders, &event, sizeof event);
  while (got < 0 && errno == EINTR);
  if (got != sizeof event) _exit(0);
  const int code = guarded([&] { return replay_(event); });
  std::fflush(nullptr);
  _exit(code);
}

// Called by a signal handler too.
int FlightRecorder::status_of(const FlightEvent& event) {
  const Copy* chosen = nullptr;
  for (const Copy& copy : copies_)
    if (!chosen || copy.clock < event.from) chosen = &copy;
  if (!chosen || write(chosen->order, &event, sizeof event) != sizeof event) return NoAnswer;
  return wait_for(chosen->process);
}

int FlightRecorder::replay(const FlightEvent& event) {
  time_to_finish(ReplaySeconds);
  const int status = status_of(event);
  if (status == NoAnswer)
    throw MissingTool(
        "the copy of the run that was to write the waveform was killed; is there memory left?");
  return status;
}

void FlightRecorder::catch_crashes(std::function<std::int64_t()> clock_now) {
  clock_now_ = std::move(clock_now);
  crashing = this;
  static char stack[1 << 16];  // the crash may be that the other one is full
  stack_t other{};
  other.ss_sp = stack;
  other.ss_size = sizeof stack;
  sigaltstack(&other, nullptr);
  for (const int number : Crashes) {
    struct sigaction action {};
    action.sa_handler = crashed;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_ONSTACK);
    struct sigaction before {};
    sigaction(number, &action, &before);
    before_.emplace_back(number, before);
  }
}

void FlightRecorder::crashed(int signal) {
  leave_rtl(signal);  // the crash of a guest, who is replayed as one that ends
  FlightRecorder& recorder = *crashing;
  const std::int64_t clock = recorder.clock_now_();
  recorder.status_of({FlightEvent::Crash, clock, clock - recorder.keep_ + 1, clock, signal});
  raise(signal);
}

}  // namespace racebeam
