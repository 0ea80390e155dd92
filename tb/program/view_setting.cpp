// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/view_setting.h"

#include <fmt/format.h>

#include <sstream>

#include "tb/base/errors.h"
#include "tb/base/nearest.h"
#include "tb/view/term_screen.h"
#include "tb/view/view_window.h"

namespace racebeam {

namespace {

void check_range(const char* option, long long value, long long min, long long max) {
  if (value < min || value > max)
    throw UsageError(fmt::format("{} {} is out of range; {}..{}", option, value, min, max));
}

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

}  // namespace

// Names of keys that do nothing are mistakes in a script.
std::vector<std::string> keys_to_press(const ViewOptions& options, KeyHelp::Chip chip) {
  const std::vector<std::string> keys = words_of(options.keys);
  std::vector<std::string> known;
  for (const KeyHelp& row : ViewControl::help(chip))
    for (const std::string& key : words_of(row.keys)) known.push_back(key);
  ViewControl control;
  if (chip == KeyHelp::Tile) control.state.inputs.emplace();
  if (chip == KeyHelp::Board) control.state.board.emplace();
  for (const std::string& key : keys)
    if (!control.press(key)) throw unknown_name("key", key, known);
  return keys;
}

Viewer::Options viewer_options(const ViewOptions& options, int frames) {
  check_range("--first", options.first, 0, frames - 1);
  check_range("--scale", options.scale, 0, 8);
  if (options.frames) check_range("--frames", *options.frames, 1, 1'000'000);
  Viewer::Options setting;
  setting.first = static_cast<int>(options.first);
  if (options.frames) setting.frames = static_cast<int>(*options.frames);
  setting.folder = options.folder;
  return setting;
}

std::unique_ptr<ViewScreen> open_screen(const ViewOptions& options) {
  return options.terminal ? open_terminal(!options.frames)
                          : open_window(static_cast<int>(options.scale));
}

}  // namespace racebeam
