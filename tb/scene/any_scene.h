// AnyScene: what a scene file of any engine has become, checked and without faults.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "sc/base/engine.h"

namespace racebeam {

/// What can be said of a scene: "planes", 4.
struct SceneFact {
  std::string name;
  std::variant<int, bool, std::string> value;
};

class AnyScene {
 public:
  virtual ~AnyScene() = default;

  /// What kind of chip shows it.
  virtual const racebeam::engine& engine() const = 0;
  virtual const std::string& name() const = 0;
  /// Pictures 0..frames() - 1, then it starts again.
  virtual int frames() const = 0;
  /// What goes into the memories of the chip.
  virtual const scene_tables& tables() const = 0;
  /// What is shown in a picture, in a few words.
  virtual std::string part(int frame) const = 0;
  /// "5 rooms, 4 portals".
  virtual std::string counts() const = 0;
  /// What `scene show` lists of it; a kind with a list of its own has none here.
  virtual std::vector<SceneFact> facts() const { return {}; }
};

}  // namespace racebeam
