// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/interrupt.h"

#include <signal.h>
#include <unistd.h>

#include <initializer_list>

#include "tb/errors.h"

namespace racebeam {

namespace {

constexpr int Patience = 3;
volatile sig_atomic_t interrupts = 0;

void count_interrupt(int) {
  interrupts = interrupts + 1;
  if (interrupts >= Patience) _exit(ExitInterrupted);
}

}  // namespace

void catch_interrupts() {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    sigaction(number, nullptr, &action);
    if (number == SIGHUP && action.sa_handler == SIG_IGN) continue;
    action.sa_handler = count_interrupt;
    action.sa_flags = SA_RESTART;
    sigaction(number, &action, nullptr);
  }
}

bool interrupted() { return interrupts > 0; }

}  // namespace racebeam
