// SceneWatch: notices that a scene file was changed, and reads it again.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "tb/show/show.h"

namespace racebeam {

class SceneWatch {
 public:
  /// A file; an empty name: there is nothing to watch.
  explicit SceneWatch(std::string file);

  /// What became of the file: a new show, or what is wrong with it.
  struct News {
    std::optional<Show> show;
    std::string error;
  };
  /// News if the file has changed since it was read. A file that is gone for a moment, as some
  /// editors make it while they save, is no news.
  std::optional<News> look();
  /// Reads it whether it has changed or not.
  News read();

 private:
  using Stamp = std::pair<std::filesystem::file_time_type, std::uintmax_t>;
  Stamp stamp() const;

  const std::string file_;
  Stamp read_at_;
};

}  // namespace racebeam
