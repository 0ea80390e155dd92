// In the place of view_window.cpp where SDL2 is not there.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/base/errors.h"
#include "tb/view/view_window.h"

namespace racebeam {

std::unique_ptr<ViewScreen> open_window(int) {
  throw MissingTool(
      "this racebeam was built without SDL2, which opens windows; apt install libsdl2-dev, then "
      "build again (scripts/build racebeam); or watch in the terminal: racebeam view --term");
}

}  // namespace racebeam
