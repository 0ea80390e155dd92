// The sweep that `racebeam sweep new` writes.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace racebeam {

/// A sweep file without faults, to start from.
const char* starter_sweep();

}  // namespace racebeam
