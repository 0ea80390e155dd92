// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <systemc>

/// libsystemc refers to it; the tests start from GoogleTest's main.
int sc_main(int, char**) { return 0; }
