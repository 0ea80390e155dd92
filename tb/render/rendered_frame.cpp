// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/render/rendered_frame.h"

#include "tb/base/byte_stream.h"

namespace racebeam {

namespace {

/// The one list of what crosses the pipe, written or read.
template <class Frame, class Field>
void each_field(Frame& frame, const Field& field) {
  field(frame.number);
  field(frame.picture.index);
  field(frame.picture.width);
  field(frame.picture.height);
  field(frame.picture.bits);
  field(frame.picture.colours);
  field(frame.picture.image_crc);
  field(frame.picture.pins_crc);
  field(frame.stats.counters);
  field(frame.stats.histograms);
  field(frame.stats.lines);
  field(frame.time.clocks);
  field(frame.time.frames);
}

}  // namespace

PictureFile picture_file(const OutputPlan& plan, int frame, const VgaFrame& picture) {
  return {plan.picture.empty() ? plan.file_name("frame", frame) : plan.picture,
          picture_bytes(*plan.format, picture)};
}

PictureFile picture_file(const OutputPlan& plan, const std::string& kind, int frame,
                         const RgbImage& picture) {
  return {plan.file_name(kind, frame), picture_bytes(*plan.format, picture)};
}

std::string RenderedFrame::bytes() const {
  ByteWriter to;
  each_field(*this, [&](const auto& value) { to.put(value); });
  to.put(golden.has_value());
  if (golden) {
    to.put(golden->by_tracer);
    to.put(golden->by_cause);
    to.put(golden->errors);
  }
  to.put(files.size());
  for (const PictureFile& file : files) {
    to.put(file.name);
    to.put(file.bytes);
  }
  return to.bytes();
}

RenderedFrame RenderedFrame::of_bytes(const std::string& bytes) {
  ByteReader from(bytes);
  RenderedFrame frame;
  each_field(frame, [&](auto& value) { from.get(value); });
  bool compared = false;
  from.get(compared);
  if (compared) {
    frame.golden.emplace();
    from.get(frame.golden->by_tracer);
    from.get(frame.golden->by_cause);
    from.get(frame.golden->errors);
  }
  std::size_t count = 0;
  from.get(count);
  frame.files.resize(count);
  for (PictureFile& file : frame.files) {
    from.get(file.name);
    from.get(file.bytes);
  }
  return frame;
}

}  // namespace racebeam
