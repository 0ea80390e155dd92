// UserInput: what a user does to a screen with keys and a mouse.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace racebeam {

class UserInput {
 public:
  /// A key by its name: "a", "space", "f1", "left" ...; others do nothing. False for those.
  virtual bool press(const std::string& key) = 0;
  virtual void release(const std::string& key) = 0;
  /// All keys are up: the window lost them.
  virtual void release_all() = 0;
  /// Pixels of the mouse, counted while flying.
  virtual void mouse(int right, int down) = 0;
  /// A click on a pixel of the picture: column 0..639, row 0..479.
  virtual void click(int column, int row) = 0;

 protected:
  ~UserInput() = default;
};

}  // namespace racebeam
