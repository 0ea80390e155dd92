// StoreSource: a chip with a frame store as a source of pictures.
//
// A frame of the viewer is a picture of the tracer, and takes as long as the hardware takes for it;
// a part of one shows that part of its rows over the picture before. What is seen is the frame
// store, as on the screen: a smaller picture leaves the rest of an older one.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "sc/base/frame_counts.h"
#include "sc/store/store_knobs.h"
#include "tb/view/frame_source.h"

namespace racebeam {

class StoreSource : public FrameSource {
 public:
  const char* level() const override { return "tlm"; }
  bool fast() const override { return true; }
  const FrameWatch& watch() const override { return watch_; }
  /// So many that a frame of the raster would take as long as the last picture.
  double clock_hz() const override;
  const PackedPicture* picture() const override { return &picture_; }
  /// The counters of the last picture that have a title.
  Rows rows() const override;
  /// What is not drawn on the way is moved by the host all the same.
  void seek(int picture) override;
  int advance(int clocks) override;

 protected:
  /// Of the raster, and bits of a channel. The engine calls begin() when it stands before picture
  /// 0 of `pictures`.
  StoreSource(const store_knobs& k, int clocks_per_pixel, int bits, int pictures);
  void begin(std::vector<std::uint64_t> store);
  int next() const { return next_; }

  /// What an engine does to stand before picture 0.
  virtual void restart() = 0;
  /// Draws the picture next(), or lets the host alone go on; the frame store then, by address.
  virtual std::vector<std::uint64_t> draw() = 0;
  virtual void skip() = 0;
  /// Rows of the picture drawn last, and clocks that it took, the host's among them.
  virtual int picture_rows() const = 0;
  virtual std::uint64_t picture_clocks() const = 0;
  virtual frame_counts counts() const = 0;
  virtual const std::vector<counter_info>& counter_infos() const = 0;
  /// What the host draws over a whole picture.
  virtual void finish(PackedPicture&) {}

 private:
  class Watch : public FrameWatch {
   public:
    using FrameWatch::FrameWatch;
    void whole_picture(int picture) {
      show(std::vector<std::uint8_t>(screen().colours().size()), picture);
    }
  };

  void compose(int rows);

  const store_knobs store_;
  const int pictures_;
  Watch watch_;
  int next_ = 0;                             // picture
  std::vector<std::uint64_t> before_, now_;  // the frame store, by address
  PackedPicture picture_;
};

}  // namespace racebeam
