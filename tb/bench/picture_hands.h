// PictureHands: what is around a wired chip that draws into a frame store: when its pictures begin
// and end. An engine's hands do what is done for a picture.
//
// A picture begins with a frame of the raster and a black store. It is over when the chip has drawn
// it and all its words are in the store.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "sc/store/picture_chip.h"
#include "tb/bench/surroundings.h"

namespace racebeam {

class PictureHands : public Surroundings {
 public:
  void seek(int picture) final;
  void clock() final;
  bool busy() const final { return busy_; }
  void rest(int frames) final { rest_ = frames; }
  int pictures() const final { return pictures_; }

  /// The frame store with the picture that was done last, by address.
  const std::vector<std::uint64_t>& memory() const { return memory_; }

 protected:
  /// `chip` is connected to a bench and stands before its first clock; it outlives the hands.
  PictureHands(picture_chip& chip, int clocks_per_pixel);

  /// All is as before a picture.
  virtual void go_to(int picture) = 0;
  /// The wires of a picture's first clock.
  virtual void begin(int picture) = 0;
  /// At the end of a clock of a picture: the wires of the next one; whether the chip has drawn it,
  /// and nothing is left to be sent.
  virtual bool send() = 0;
  /// The wires of the last clock before a picture.
  virtual void prepare(int) {}
  /// The picture is over.
  virtual void end() = 0;

  /// In send(): the next clock is the first of a frame.
  bool frame_is_over() const { return frame_clock_ == 0; }
  /// After this picture, the next one begins with seek().
  void hold() { held_ = true; }
  /// The same, and this one is not looked at any more.
  void give_up();

 private:
  void begin_next();

  picture_chip& chip_;
  const int frame_clocks_;
  int next_ = 0;         // picture to be begun
  int frame_clock_ = 0;  // that is being simulated
  bool begun_ = false, busy_ = false, held_ = false;
  int pictures_ = 0;
  int rest_ = 0, resting_ = 0;  // frames after a picture; of them still to come
  std::vector<std::uint64_t> memory_;
};

}  // namespace racebeam
