// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/view_control.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <sstream>
#include <utility>

namespace racebeam {

namespace {

using Keys = std::map<std::string, std::function<void(ViewState&)>>;

const std::map<std::string, ViewAction>& action_keys() {
  static const std::map<std::string, ViewAction> keys{
      {".", ViewAction::StepFrame},    {"l", ViewAction::StepLine},
      {"j", ViewAction::StepTenLines}, {"k", ViewAction::StepPixel},
      {"c", ViewAction::StepClock},    {"r", ViewAction::Rewind},
      {"left", ViewAction::Back},      {"right", ViewAction::Forward},
      {"o", ViewAction::Screenshot},   {"f12", ViewAction::Screenshot},
      {"v", ViewAction::Record},       {"f", ViewAction::Fly},
      {"f5", ViewAction::Reload},      {"escape", ViewAction::Quit},
      {"q", ViewAction::Quit}};
  return keys;
}

void show_map(ViewState& s, MapKind kind) {
  if (s.map == kind) s.map.reset();
  else s.map = kind;
}

void change_speed(ViewState& s, int by) {
  s.speed = std::clamp(s.speed + by, ViewControl::SlowestSpeed, ViewControl::FastestSpeed);
}

const Keys& state_keys() {
  static const Keys keys{
      {"space", [](ViewState& s) { s.paused = !s.paused; }},
      {"p", [](ViewState& s) { s.paused = !s.paused; }},
      {"=", [](ViewState& s) { change_speed(s, 1); }},
      {"+", [](ViewState& s) { change_speed(s, 1); }},
      {"-", [](ViewState& s) { change_speed(s, -1); }},
      {"0", [](ViewState& s) { s.map.reset(); }},
      {"1", [](ViewState& s) { show_map(s, MapKind::Slack); }},
      {"2", [](ViewState& s) { show_map(s, MapKind::Cost); }},
      {"3", [](ViewState& s) { show_map(s, MapKind::Depth); }},
      {"b", [](ViewState& s) { s.beam = !s.beam; }},
      {"i", [](ViewState& s) { s.borders = !s.borders; }},
      {"g", [](ViewState& s) { s.gauges = !s.gauges; }},
      {"t", [](ViewState& s) { s.text = !s.text; }},
      {"h", [](ViewState& s) { s.help = !s.help; }},
      {"f1", [](ViewState& s) { s.help = !s.help; }},
      {"m", [](ViewState& s) { s.muted = !s.muted; }},
      {"f11", [](ViewState& s) { s.full_screen = !s.full_screen; }},
  };
  return keys;
}

bool pauses(ViewAction action) {
  return action == ViewAction::StepFrame || action == ViewAction::StepLine ||
         action == ViewAction::StepTenLines || action == ViewAction::StepPixel ||
         action == ViewAction::StepClock;
}

const std::vector<KeyHelp>& all_help() {
  static const std::vector<KeyHelp> rows{
      {"space p", "pause, go on"},
      {". l k c", "step a frame, visible line, pixel, clock"},
      {"j", "step ten lines"},
      {"r", "rewind to the first frame"},
      {"left right", "a second back, on"},
      {"+ = -", "faster, slower"},
      {"1 2 3", "map of slack, cost, depth", KeyHelp::Model},
      {"0", "no map", KeyHelp::Model},
      {"0 1 2 3", "ui_in[0] to ui_in[3]: 1, 0", KeyHelp::Tile},
      {"4 5 6 7", "ui_in[4] to ui_in[7]: 1, 0", KeyHelp::Tile},
      {"u", "the numbers are uio_in, ui_in", KeyHelp::Tile},
      {"w", "write the inputs so far to a file", KeyHelp::Tile},
      {"0 1 2 3 4", "SW0 4x, SW1 8x, SW2 SW3 reflections, SW4 scene", KeyHelp::Board},
      {"5", "SW5: 512 x 480", KeyHelp::Board},
      {"6 7 8 9", "SW6 -z, SW7 +z, SW8 -y, SW9 +y of the eye", KeyHelp::Board},
      {"u", "0 to 7 are SW10 to SW17, or SW0 to SW9 again:", KeyHelp::Board},
      {"u 0 1", "SW10 -x, SW11 +x of the eye", KeyHelp::Board},
      {"u 2 3 4", "SW12 -z, SW13 +z, SW14 -y of the light", KeyHelp::Board},
      {"u 5 6 7", "SW15 +y, SW16 -x, SW17 +x of the light", KeyHelp::Board},
      {"a d", "KEY0 wider, KEY1 narrower, for a picture", KeyHelp::Board},
      {"s w", "KEY2 held, let go: planes; KEY3: reset", KeyHelp::Board},
      {"b", "beam position"},
      {"i", "borders of intervals; a click: what explains a pixel", KeyHelp::Model},
      {"g", "gauges of FIFO and stacks", KeyHelp::Model},
      {"t", "statistics"},
      {"f", "free flight, paused too; back to the path", KeyHelp::Model},
      {"w a s d", "fly ahead, left, back, right", KeyHelp::Model},
      {"e x", "rise, sink", KeyHelp::Model},
      {"up down", "look up, down; mouse: look around", KeyHelp::Model},
      {"o f12", "screenshot"},
      {"v", "record a GIF of the chip's own picture, stop"},
      {"f5", "load the scene file again", KeyHelp::Model},
      {"m", "sound off, on"},
      {"f11", "full screen"},
      {"h f1", "this help"},
      {"q escape", "quit"},
  };
  return rows;
}

bool has_key(const KeyHelp& row, const std::string& key) {
  std::istringstream keys(row.keys);
  return std::find(std::istream_iterator<std::string>(keys), {}, key) !=
         std::istream_iterator<std::string>();
}

// Keys that move the camera while it flies; the arrows have another meaning otherwise.
bool flight_key(const std::string& key) {
  static const std::set<std::string> keys{"w", "a",    "s",  "d",    "e",
                                          "x", "left", "up", "down", "right"};
  return keys.count(key) > 0;
}

}  // namespace

// One of the model, which the chip on show has not.
bool ViewControl::key_of_model(const std::string& key) {
  const auto has = [&](KeyHelp::Chip chip) {
    return std::any_of(help(chip).begin(), help(chip).end(),
                       [&](const KeyHelp& row) { return has_key(row, key); });
  };
  if (!has(KeyHelp::Model) || has(chip_of(state))) return false;
  actions_.push(ViewAction::ModelOnly);
  return true;
}

// What a board makes of a key. Those of KEY0, KEY1 and KEY3 come up by themselves.
bool ViewControl::board_key(const std::string& key) {
  static const std::map<std::string, int> keys{{"a", 0}, {"d", 1}, {"s", 2}, {"w", 3}};
  constexpr int Switches = 18, FirstHigh = 10;
  if (key.size() == 1 && key[0] >= '0' && key[0] <= '9') {
    const int number = key[0] - '0' + (state.high_switches ? FirstHigh : 0);
    if (number < Switches) state.board->switches ^= 1 << number;
  } else if (key == "u") {
    state.high_switches = !state.high_switches;
  } else if (const auto known = keys.find(key); known != keys.end()) {
    state.board->keys ^= 1 << known->second;
  } else {
    return key_of_model(key);
  }
  return true;
}

// What a chip of its own makes of a key.
bool ViewControl::tile_key(const std::string& key) {
  if (key.size() == 1 && key[0] >= '0' && key[0] <= '7') {
    std::uint8_t& pins = state.uio_keys ? state.inputs->uio : state.inputs->ui;
    pins = static_cast<std::uint8_t>(pins ^ 1 << (key[0] - '0'));
  } else if (key == "u") {
    state.uio_keys = !state.uio_keys;
  } else if (key == "w") {
    actions_.push(ViewAction::WriteInputs);
  } else {
    return key_of_model(key);
  }
  return true;
}

bool ViewControl::press(const std::string& key) {
  if (state.inputs && tile_key(key)) return true;
  if (state.board && board_key(key)) return true;
  if (state.plain && key_of_model(key)) return true;
  if (flight_key(key)) held_.insert(key);
  if (state.flying && flight_key(key)) {
    tapped_.insert(key);
    return true;
  }
  if (const auto known = state_keys().find(key); known != state_keys().end()) {
    known->second(state);
    return true;
  }
  const auto known = action_keys().find(key);
  if (known == action_keys().end()) {
    if (flight_key(key)) actions_.push(ViewAction::FlightHint);
    return flight_key(key);
  }
  if (pauses(known->second)) state.paused = true;
  actions_.push(known->second);
  return true;
}

void ViewControl::release(const std::string& key) { held_.erase(key); }

void ViewControl::click(int column, int row) {
  click_ = {column, row};
  actions_.push(ViewAction::Explain);
}

void ViewControl::mouse(int right, int down) {
  if (!state.flying) return;
  mouse_.right += right;
  mouse_.down += down;
}

std::optional<ViewAction> ViewControl::take_action() {
  if (actions_.empty()) return {};
  const ViewAction action = actions_.front();
  actions_.pop();
  return action;
}

ViewControl::Motion ViewControl::motion() const {
  const auto both = [this](const char* plus, const char* minus) {
    return held(plus) - held(minus);
  };
  return {both("w", "s"), both("d", "a"), both("e", "x"), both("right", "left"),
          both("down", "up")};
}

ViewControl::Motion ViewControl::take_motion() {
  const Motion taken = motion();
  tapped_.clear();
  return taken;
}

bool ViewControl::steered() const {
  const Motion m = motion();
  return m.ahead || m.right || m.up || m.turn || m.tilt || mouse_.right || mouse_.down;
}

ViewControl::Look ViewControl::take_mouse() { return std::exchange(mouse_, {}); }

const std::vector<KeyHelp>& ViewControl::help(KeyHelp::Chip chip) {
  const auto rows_of = [](KeyHelp::Chip chip) {
    std::vector<KeyHelp> rows;
    for (const KeyHelp& row : all_help())
      if (row.chip == KeyHelp::Any || row.chip == chip) rows.push_back(row);
    return rows;
  };
  static const std::map<KeyHelp::Chip, std::vector<KeyHelp>> all = {
      {KeyHelp::Model, rows_of(KeyHelp::Model)},
      {KeyHelp::Tile, rows_of(KeyHelp::Tile)},
      {KeyHelp::Board, rows_of(KeyHelp::Board)},
      {KeyHelp::Plain, rows_of(KeyHelp::Plain)}};
  return all.at(chip);
}

}  // namespace racebeam
