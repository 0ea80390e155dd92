// Included before every source of a plug-in, and parsed once for all: Verilator's headers, with
// what its run-time library asks of sc/swap/rtl_glue.cc.in instead of ending the program or
// printing to its standard output.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#define VL_USER_FINISH
#define VL_USER_STOP
#define VL_USER_FATAL
#define VL_PRINTF rtl_printf

int rtl_printf(const char* format, ...) __attribute__((format(printf, 1, 2)));

#include "verilated.h"
#include "verilated_syms.h"
