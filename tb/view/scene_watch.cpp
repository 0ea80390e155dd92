// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/scene_watch.h"

#include <system_error>
#include <utility>

#include "tb/scene/scene_reader.h"

namespace racebeam {

namespace fs = std::filesystem;

SceneWatch::SceneWatch(std::string file) : file_(std::move(file)), read_at_(stamp()) {}

SceneWatch::Stamp SceneWatch::stamp() const {
  std::error_code error;
  const auto time = fs::last_write_time(file_, error);
  if (error) return {};
  const auto size = fs::file_size(file_, error);
  return error ? Stamp{} : Stamp{time, size};
}

std::optional<SceneWatch::News> SceneWatch::look() {
  if (file_.empty()) return {};
  const Stamp now = stamp();
  if (now == read_at_ || now == Stamp{}) return {};
  return read();
}

SceneWatch::News SceneWatch::read() {
  if (file_.empty()) return {{}, "the built-in demo has no file to load again"};
  read_at_ = stamp();
  SceneResult result = read_scene_file(file_);
  if (!result.faults.none()) return {{}, result.faults.text(file_)};
  return {Show(std::move(result.scene), "reloaded"), ""};
}

}  // namespace racebeam
