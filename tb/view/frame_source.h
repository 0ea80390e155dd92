// FrameSource: a chip that runs for a viewer, at whatever level.
//
// It stands before some clock of a frame and is moved on by clocks, never past the end of a frame,
// so that a line, a pixel or a whole frame are the same request with other numbers.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sc/base/fixed_point.h"
#include "tb/base/packed_picture.h"
#include "tb/bench/frame_watch.h"
#include "tb/bench/interval_event.h"
#include "tb/tt/tt_inputs.h"
#include "tb/view/board_pins.h"

namespace racebeam {

/// Where a free camera is: position from the centre of its room, turns in 1/2048, fov in pixels.
struct Pose {
  int room = 0;
  vec3 position{};
  int yaw = 0, pitch = 0, fov = 96;
};

/// Something in the chip that is fuller or emptier.
struct Gauge {
  const char* title;
  std::vector<std::uint64_t> seen;  ///< clocks of this frame by value, for bars; empty: no bars
  int most, now;
  bool alarm;
};

class FrameSource {
 public:
  static constexpr int SoundRate = 63000;  ///< samples a second: two a line

  virtual ~FrameSource() = default;

  /// "tlm", "signal", "verilated".
  virtual const char* level() const = 0;
  /// Simulates frames at about the pace of the show: frames that come too late may be left out.
  /// Else every clock is shown as it comes.
  virtual bool fast() const = 0;
  virtual const FrameWatch& watch() const = 0;
  /// Clocks a second of the chip itself.
  virtual double clock_hz() const;
  /// The picture on show, if it has more colours than watch() knows; of the raster's size.
  virtual const PackedPicture* picture() const { return nullptr; }
  /// Names and values for the statistics; an empty pair is an empty line.
  using Rows = std::vector<std::pair<std::string, std::string>>;
  virtual Rows rows() const { return {}; }
  /// For the panel, at the beam.
  virtual std::vector<Gauge> gauges() const { return {}; }
  /// Of the frame so far, if the chip has such.
  virtual const std::vector<IntervalEvent>& intervals() const;

  /// Stands before the first clock of `frame`, on the camera's own path. A frame that is half shown
  /// is given up, or shown to its end where the level cannot do that.
  virtual void seek(int frame) = 0;
  /// Runs up to `clocks` clocks, not past the end of the frame. Returns how many it ran.
  virtual int advance(int clocks) = 0;

  /// Whether fly() works.
  virtual bool can_fly() const { return false; }
  /// Before the first clock of a frame: the next frame is a frame of the shot that holds at
  /// `frame`, seen from `pose`. seek() ends it.
  virtual void fly(int frame, const Pose& pose);

  /// The input pins, if the chip has some that can be pressed; and all of them so far, as a file.
  virtual std::optional<TilePins> inputs() const { return {}; }
  virtual std::string inputs_text() const { return ""; }
  /// They are others from the next clock on.
  virtual void press(TilePins) {}
  /// The board, if the chip is on one.
  virtual std::optional<BoardPins> board() const { return {}; }
  /// It is like this from the next picture on.
  virtual void press(BoardPins) {}
  /// Nothing can be pressed, flown or mapped.
  virtual bool plain() const { return false; }
  /// The scene alone says what is on show: nobody has touched the board.
  virtual bool as_in_scene() const { return true; }
  /// What a frame sounds like if it is to be heard without being run, at SoundRate.
  virtual std::vector<float> play(int /*frame*/) { return {}; }
  /// What the source played since the last call, at SoundRate.
  virtual std::vector<float> take_sound() { return {}; }

  /// Clocks up to the end of the frame; of a whole frame if it stands before the first.
  int clocks_left() const {
    const int all = watch().raster().frame_clocks();
    return watch().whole() ? all : all - watch().seen();
  }
};

}  // namespace racebeam
