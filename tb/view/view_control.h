// ViewControl: from keys to what a viewer shows and does. Knows no window.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <queue>
#include <set>
#include <string>
#include <vector>

#include "tb/tt/tt_inputs.h"
#include "tb/view/board_pins.h"
#include "tb/view/frame_maps.h"
#include "tb/view/user_input.h"

namespace racebeam {

/// What is to be done once.
enum class ViewAction {
  StepFrame,
  StepLine,
  StepTenLines,
  StepPixel,
  StepClock,
  Rewind,
  Back,
  Forward,
  Screenshot,
  Record,
  Fly,
  FlightHint,  ///< a key of the free flight, out of it
  Explain,     ///< the pixel of clicked()
  Reload,
  WriteInputs,
  ModelOnly,  ///< a key that needs the model, of a chip that is none
  Quit,
};

/// What holds until a key changes it.
struct ViewState {
  bool paused = false;
  int speed = 0;  ///< clocks of real time times 2^speed
  std::optional<MapKind> map;
  bool beam = false, borders = false, gauges = false, text = false, help = false;
  bool muted = false, full_screen = false;
  bool flying = false;  ///< set by whoever takes ViewAction::Fly
  /// Input pins that keys toggle, of a chip of its own; of the model nothing.
  std::optional<TilePins> inputs;
  bool uio_keys = false;  ///< they toggle uio_in instead of ui_in
  /// Switches and keys of the board, of a chip on one.
  std::optional<BoardPins> board;
  bool high_switches = false;  ///< the numbers are SW10 to SW17
  bool plain = false;          ///< a chip without keys of its own
};

/// One row of the help.
struct KeyHelp {
  enum Chip { Any, Model, Tile, Board, Plain };
  std::string keys, meaning;
  /// That has the keys: a Tile is a chip of its own, a Board has switches, a Plain one has none.
  Chip chip = Any;
};

class ViewControl : public UserInput {
 public:
  static constexpr int SlowestSpeed = -12, FastestSpeed = 3;

  bool press(const std::string& key) override;
  void release(const std::string& key) override;
  void release_all() override {
    held_.clear();
    tapped_.clear();
  }
  void mouse(int right, int down) override;
  void click(int column, int row) override;

  /// The oldest action that was not taken.
  std::optional<ViewAction> take_action();
  /// -1, 0 or 1 of the keys that are held: ahead, to the right, up; turning right, down.
  struct Motion {
    int ahead = 0, right = 0, up = 0, turn = 0, tilt = 0;
  };
  /// Of keys that were released since the last call, too.
  Motion take_motion();
  struct Look {
    int right = 0, down = 0;
  };
  /// How far the mouse has moved since the last call.
  Look take_mouse();
  /// take_motion() or take_mouse() would tell of some.
  bool steered() const;
  struct Pixel {
    int column = 0, row = 0;
  };
  /// Where the last click was.
  Pixel clicked() const { return click_; }

  ViewState state;

  /// Every key of a chip, as press() knows them: a test holds that.
  static const std::vector<KeyHelp>& help(KeyHelp::Chip chip = KeyHelp::Model);
  /// Of the chip that is on show.
  const std::vector<KeyHelp>& help_on_show() const { return help(chip_of(state)); }
  static KeyHelp::Chip chip_of(const ViewState& state) {
    return state.inputs  ? KeyHelp::Tile
           : state.board ? KeyHelp::Board
           : state.plain ? KeyHelp::Plain
                         : KeyHelp::Model;
  }

 private:
  int held(const char* key) const { return held_.count(key) + tapped_.count(key) > 0 ? 1 : 0; }
  Motion motion() const;
  bool tile_key(const std::string& key);
  bool board_key(const std::string& key);
  bool key_of_model(const std::string& key);

  std::queue<ViewAction> actions_;
  std::set<std::string> held_, tapped_;  // tapped: since the last take_motion()
  Look mouse_;
  Pixel click_;
};

}  // namespace racebeam
