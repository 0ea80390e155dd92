// racebeam report: a sweep as one page to look at.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/program/command.h"

namespace racebeam {

Command report_row();

}  // namespace racebeam
