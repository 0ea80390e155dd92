// A scene file of the voxel tracer, by its text.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "tb/scene/voxel_scene.h"

namespace racebeam {

/// Files that it names lie in `folder`.
class VoxelText {
 public:
  explicit VoxelText(const std::string& text, const std::string& folder = "") {
    if (const std::optional<TomlNode> root = parse_toml(text, faults_))
      scene_ = read_voxel_scene({*root, text, "test", folder}, faults_);
  }

  const std::shared_ptr<const AnyScene>& scene() const { return scene_; }
  std::string faults() const { return faults_.text("f"); }
  std::string warnings() const { return faults_.warnings("f"); }
  int count() const { return faults_.count(); }

  /// There are neither faults nor warnings.
  VoxelProgram good() const {
    EXPECT_EQ(faults(), "");
    EXPECT_EQ(warnings(), "");
    return scene_ ? static_cast<const VoxelScene&>(*scene_).tables() : VoxelProgram();
  }

 private:
  Faults faults_;
  std::shared_ptr<const AnyScene> scene_;
};

}  // namespace racebeam
