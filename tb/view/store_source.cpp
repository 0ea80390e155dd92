// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/store_source.h"

#include <algorithm>
#include <utility>

#include "sc/base/constants.h"
#include "sc/store/frame_scanout.h"

namespace racebeam {

StoreSource::StoreSource(const store_knobs& k, int clocks_per_pixel, int bits, int pictures)
    : store_(k), pictures_(pictures), watch_(Raster(clocks_per_pixel)) {
  picture_.width = watch_.raster().columns;
  picture_.height = watch_.raster().rows;
  picture_.bits = bits;
}

void StoreSource::begin(std::vector<std::uint64_t> store) {
  next_ = 0;
  now_ = std::move(store);
  before_ = now_;
  compose(0);
}

double StoreSource::clock_hz() const {
  constexpr double PicosecondsPerSecond = 1e12;
  const Raster& raster = watch_.raster();
  const double hz =
      PicosecondsPerSecond / clock_period_ps(raster.frame_clocks() / (LinePixels * FrameLines));
  const auto taken = static_cast<double>(picture_clocks());
  return taken > 0 ? hz * raster.frame_clocks() / taken : hz;
}

void StoreSource::compose(int rows) {
  const int low = DacBits - picture_.bits;
  picture_.colours.clear();
  for (int y = 0; y < picture_.height; ++y) {
    const std::vector<std::uint64_t>& words = y < rows ? now_ : before_;
    for (int x = 0; x < picture_.width; ++x) {
      frame_scanout_core::colour dac{};
      if (x < store_.picture_width || store_.wrap_right)
        dac = frame_scanout_core::pixel(words, y, x, store_);
      picture_.push(static_cast<std::uint32_t>(
          (dac.red >> low << picture_.bits | dac.green >> low) << picture_.bits | dac.blue >> low));
    }
  }
}

void StoreSource::seek(int picture) {
  if (picture < next_) {
    restart();
    next_ = 0;
  }
  for (; next_ < picture; ++next_) skip();
  watch_.restart();
}

int StoreSource::advance(int clocks) {
  const int all = watch_.raster().frame_clocks(), count = std::min(clocks, clocks_left());
  if (watch_.whole() || watch_.seen() == 0) {
    if (next_ == pictures_) {
      restart();
      next_ = 0;
    }
    before_ = std::exchange(now_, draw());
    ++next_;
  }
  if (count == all) {
    watch_.whole_picture(next_ - 1);
  } else {
    for (int n = 0; n < count; ++n) watch_.clock(0, next_ - 1);
  }
  compose(watch_.whole() ? picture_.height
                         : static_cast<int>(std::int64_t{picture_rows()} * watch_.seen() / all));
  if (watch_.whole()) finish(picture_);
  return count;
}

FrameSource::Rows StoreSource::rows() const {
  Rows rows;
  const frame_counts counted = counts();
  const std::vector<counter_info>& infos = counter_infos();
  for (std::size_t n = 0; n < counted.counters.size(); ++n)
    if (*infos[n].title) rows.emplace_back(infos[n].title, std::to_string(counted.counters[n]));
  return rows;
}

}  // namespace racebeam
