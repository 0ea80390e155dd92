// Surroundings: what a chip has around it on the board besides clock, reset and screen: a CPU,
// hands at the switches. WiredBench clocks it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace racebeam {

class Surroundings {
 public:
  virtual ~Surroundings() = default;

  /// In the first clock of a frame, the chip not busy: the picture to come.
  virtual void seek(int picture) = 0;
  /// At the edge that ends each clock, the wires settled.
  virtual void clock() = 0;
  /// A picture was begun, and is not done.
  virtual bool busy() const = 0;
  /// The host is at work, and nobody waits for the chip.
  virtual bool sends() const { return false; }
  /// Begins no picture until the next seek(). The one that was begun is given up, which takes a
  /// frame; or it ends while the chip is busy.
  virtual void stop() = 0;
  /// Lets so many frames go by after each picture, which the screen then shows.
  virtual void rest(int frames) = 0;
  /// Pictures that are done since the start.
  virtual int pictures() const = 0;
};

}  // namespace racebeam
