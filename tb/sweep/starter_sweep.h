// The sweep that `racebeam sweep new` writes.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace racebeam {

/// A sweep file without faults, to start from; the figures that there are stand in its comments.
std::string starter_sweep();

}  // namespace racebeam
