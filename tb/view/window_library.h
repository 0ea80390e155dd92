// WindowLibrary: what SDL2 does for the program, opened when it is first asked for.
//
// SDL2 brings 30 shared libraries, of displays and of loudspeakers. It is behind
// libracebeam_window.so, a library of the program's own, which knows windows and no viewer.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "tb/view/user_input.h"
#include "tb/view/view_layout.h"

namespace racebeam {

/// A window and a loudspeaker. All of it may throw MissingTool.
class LibraryWindow {
 public:
  virtual ~LibraryWindow() = default;

  /// The mouse is the flight's: it has no pointer, and does not leave.
  virtual void keep_mouse(bool kept) = 0;
  virtual void fill_screen(bool filled) = 0;
  /// Hands on what the user did since the last call. True if the picture must be shown again.
  virtual bool poll(UserInput& user) = 0;
  /// Three bytes a pixel, row by row. The user clicks on pixels of `chip`, its top left part.
  virtual void show(const std::uint8_t* rgb, Extent picture, Extent chip,
                    const std::string& title) = 0;
  /// Samples, -1..1.
  virtual void play(const std::vector<float>& samples) = 0;
};

struct WindowLibrary {
  std::string (*version)();  ///< of SDL2

  /// As open_window(), which says what `scale` is. `tell` takes a line for the user. The rate of
  /// sound is samples a second.
  std::unique_ptr<LibraryWindow> (*open)(int scale, int sound_rate, void (*tell)(std::string_view));
};

/// Opens it at the first call. Throws MissingTool if it or SDL2 is not there.
const WindowLibrary& window_library();

}  // namespace racebeam
