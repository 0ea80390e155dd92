// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/base/interrupt.h"

#include <signal.h>
#include <time.h>
#include <unistd.h>

#include <initializer_list>
#include <string_view>

#include "sc/swap/rtl_run.h"
#include "tb/base/errors.h"

namespace racebeam {

namespace {

constexpr int Patience = 3;     // signals
constexpr int Seconds = 5;      // of waiting
constexpr int BusySeconds = 1;  // of processor time
volatile sig_atomic_t interrupts = 0;
volatile sig_atomic_t waited = 0;  // seconds since the first one
volatile sig_atomic_t finish = 0;  // seconds to finish, once that has begun
volatile double busy_before = 0;   // processor time at the first one

double busy_seconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

void end_at_once(int) { _exit(ExitInterrupted); }

[[noreturn]] void end_unfinished() {
  constexpr std::string_view Text = "racebeam: stopped early, in the middle of its work\n";
  if (write(STDERR_FILENO, Text.data(), Text.size()) < 0) _exit(ExitInterrupted);
  _exit(ExitInterrupted);
}

void count_interrupt(int) {
  interrupts = interrupts + 1;
  if (interrupts >= Patience) end_unfinished();
  if (interrupts > 1) return;
  busy_before = busy_seconds();
  alarm(1);
}

// Every second from the first signal on.
void look_at_clock(int) {
  alarm(1);
  waited = waited + 1;
  const bool busy = busy_seconds() - busy_before >= BusySeconds;
  if (finish == 0 && busy) leave_rtl(SIGALRM);
  if (finish == 0 ? busy || waited >= Seconds : waited >= finish) end_unfinished();
}

void handle(void (*handler)(int)) {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    sigaction(number, nullptr, &action);
    if (number == SIGHUP && action.sa_handler == SIG_IGN) continue;
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART | SA_ONSTACK;
    sigaction(number, &action, nullptr);
  }
}

}  // namespace

void end_on_interrupts() { handle(end_at_once); }

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = look_at_clock;
  action.sa_flags = SA_RESTART | SA_ONSTACK;
  sigaction(SIGALRM, &action, nullptr);
  handle(count_interrupt);
}

bool interrupted() { return interrupts > 0; }

void time_to_finish(int seconds) { finish = static_cast<sig_atomic_t>(waited + seconds); }

}  // namespace racebeam
