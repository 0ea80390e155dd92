// The viewer in a terminal.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "tb/view/view_screen.h"

namespace racebeam {

/// Takes over the terminal at stdout, and gives it back as it was. Where stdout is none, pictures
/// follow each other as text of COLUMNS x LINES, or 80 x 24, letters: `endless` says that they
/// would never end, which is a UsageError.
std::unique_ptr<ViewScreen> open_terminal(bool endless);

}  // namespace racebeam
