// The program racebeam: starts SystemC quietly, runs the command, turns errors into exit codes.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <signal.h>
#include <sysc/kernel/sc_externs.h>
#include <sysc/utils/sc_report.h>
#include <sysc/utils/sc_report_handler.h>

#include <cstdlib>

#include "tb/base/console.h"
#include "tb/base/guarded.h"
#include "tb/base/interrupt.h"
#include "tb/program/command_line.h"

namespace racebeam {

namespace {

// Results alone go to stdout: what SystemC reports belongs on stderr.
void report(const sc_core::sc_report& message, const sc_core::sc_actions& actions) {
  if (message.get_severity() >= sc_core::SC_ERROR)
    sc_core::sc_report_handler::default_handler(message, actions);
  else if (actions & sc_core::SC_DISPLAY) tell(message.what());
}

int run(int argc, char** argv) {
  sc_core::sc_report_handler::set_handler(report);
  keep_stdout();
  end_on_interrupts();
  return guarded([&] { return run_command_line(argc, argv); });
}

}  // namespace

}  // namespace racebeam

int sc_main(int argc, char** argv) { return racebeam::run(argc, argv); }

// Instead of the SystemC library's main, which prints a banner.
int main(int argc, char** argv) {
  setenv("SYSTEMC_DISABLE_COPYRIGHT_MESSAGE", "1", 1);
  signal(SIGXFSZ, SIG_IGN);  // a file that grows too large is an error of the write
  signal(SIGPIPE, SIG_IGN);  // and so is a reader that has gone: see ClosedPipe
  return sc_core::sc_elab_and_sim(argc, argv);
}
