// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/base/simulate.h"

#include <sysc/kernel/sc_kernel_ids.h>

#ifdef __SANITIZE_ADDRESS__
#include <dlfcn.h>
#include <pthread.h>

#include <cstddef>
#endif
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

#ifdef __SANITIZE_ADDRESS__
namespace {

/// Of the thread that asks first.
struct OwnStack {
  void* bottom = nullptr;
  std::size_t size = 0;
  OwnStack() {
    pthread_attr_t thread;
    if (pthread_getattr_np(pthread_self(), &thread) != 0) return;
    pthread_attr_getstack(&thread, &bottom, &size);
    pthread_attr_destroy(&thread);
  }
};

}  // namespace

// SystemC tells AddressSanitizer whenever it goes to another stack, but says nullptr of the
// program's own: from then on what an exception leaves there is taken for an overflow.
extern "C" __attribute__((no_sanitize("address"))) void __sanitizer_start_switch_fiber(
    void** fake_stack, const void* bottom, std::size_t size) {
  using Switch = void (*)(void**, const void*, std::size_t);
  static const auto start =
      reinterpret_cast<Switch>(dlsym(RTLD_NEXT, "__sanitizer_start_switch_fiber"));
  static const OwnStack own;
  if (bottom) start(fake_stack, bottom, size);
  else start(fake_stack, own.bottom, own.size);
}
#endif
