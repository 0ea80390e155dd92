// built_in_plugin: what stands in the place of RTL and is no file, but part of this program.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "sc/swap/rtl_model.h"

namespace racebeam {

/// As long as it lives, its name stands for it where the path of a plug-in is asked for.
class built_in_plugin {
 public:
  /// `make`: a new instance.
  explicit built_in_plugin(std::function<rtl_model*()> make);
  ~built_in_plugin();
  built_in_plugin(const built_in_plugin&) = delete;
  built_in_plugin& operator=(const built_in_plugin&) = delete;

  const std::string& name() const { return name_; }

 private:
  std::string name_;
};

}  // namespace racebeam
