// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/cli/view_pictures.h"

#include <OpenImageIO/imageio.h>

#include "sc/beam/chip_core.h"
#include "tb/bench/core_bench.h"
#include "tb/bench/interval_watcher.h"

namespace racebeam {

Bytes read_rgb(const std::string& path) {
  const auto in = OIIO::ImageInput::open(path);
  if (!in || in->spec().nchannels != 3) return {};
  Bytes bytes(static_cast<std::size_t>(in->spec().width) * in->spec().height * 3);
  if (!in->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, bytes.data())) return {};
  return bytes;
}

std::vector<IntervalEvent> intervals_of(int frame) {
  const knobs k;
  chip_core chip;
  chip.clock(false, k);
  chip.deposit(frame, k);
  IntervalWatcher watcher;
  for (long left = 2L * LinePixels * FrameLines; left > 0; --left) {
    const int room = chip.decision_datapath.room_q, face = chip.decision_datapath.hit_face_q;
    chip_view view;
    chip.clock(true, k, &view);
    watcher.observe(view, room, face);
  }
  return watcher.take();
}

Bytes bytes_of(const RgbImage& picture) {
  return {picture.bytes(), picture.bytes() + 3 * picture.width() * picture.height()};
}

Bytes frame_of(int frame) {
  return bytes_of(RgbImage(CoreBench({}, frame).picture(), VisibleColumns, VisibleRows,
                           VisibleColumns, VisibleRows));
}

Bytes map_of(MapKind kind, int frame) {
  return bytes_of(map_picture(make_map(kind, intervals_of(frame), Raster()),
                              "demo frame " + std::to_string(frame)));
}

}  // namespace racebeam
