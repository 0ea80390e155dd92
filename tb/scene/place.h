// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace racebeam {

/// Where in a file something was written; from 1, 0: nowhere.
struct Place {
  int line = 0, column = 0;
};

}  // namespace racebeam
