// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/base/simulate.h"

#include <sysc/kernel/sc_kernel_ids.h>

#include <string>

#include "sc/swap/rtl_library.h"

namespace racebeam {

// What processes throw arrives as a report of the kernel; only RTL throws in one.
void simulate(const sc_core::sc_time& time) {
  try {
    sc_core::sc_start(time);
  } catch (const sc_core::sc_report& report) {
    if (std::string(report.get_msg_type()) != sc_core::SC_ID_SIMULATION_UNCAUGHT_EXCEPTION_) throw;
    throw RtlFault(report.get_msg());
  }
}

}  // namespace racebeam
