// SphereSource: the sphere tracer, its board and its CPU as a source of pictures.
//
// A frame of the viewer is a picture of the tracer, and takes as long as the hardware takes for it;
// a part of one shows that part of its rows over the picture before. What is seen is the frame
// store, as on the screen: a smaller picture leaves the rest of an older one.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sc/sphere/sphere_core.h"
#include "tb/host/sphere_program.h"
#include "tb/view/frame_source.h"
#include "tb/view/sources.h"

namespace racebeam {

class SphereSource : public FrameSource {
 public:
  /// Stands before picture 0 of `pictures`. The program outlives it.
  SphereSource(const SphereProgram& program, const sphere_knobs& k, int pictures);

  const char* level() const override { return "tlm"; }
  bool fast() const override { return true; }
  const FrameWatch& watch() const override { return watch_; }
  /// So many that a frame of the raster would take as long as the last picture.
  double clock_hz() const override;
  const PackedPicture* picture() const override { return &picture_; }
  Rows rows() const override;
  /// What is not drawn on the way is moved by CPU and board all the same.
  void seek(int picture) override;
  int advance(int clocks) override;
  std::optional<BoardPins> board() const override { return pins_; }
  void press(BoardPins pins) override;
  bool as_in_scene() const override { return !touched_; }

 private:
  class Watch : public FrameWatch {
   public:
    using FrameWatch::FrameWatch;
    void whole_picture(int picture) {
      show(std::vector<std::uint8_t>(screen().colours().size()), picture);
    }
  };

  void restart();
  sphere_board board_now() const;
  void begin();
  void end();
  void draw();
  void skip();
  void compose(int rows);

  const SphereProgram& program_;
  const sphere_knobs knobs_;
  const int pictures_;
  Watch watch_;
  std::optional<sphere_core> core_;
  std::optional<SphereMotion> motion_;
  BoardPins pins_;
  bool touched_ = false;
  int next_ = 0;                             // picture
  std::vector<std::uint64_t> before_, now_;  // the frame store, by address
  PackedPicture picture_;
};

/// The row of sources().
SourceKind sphere_sources();

}  // namespace racebeam
