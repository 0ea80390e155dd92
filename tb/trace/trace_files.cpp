// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/trace/trace_files.h"

#include <memory>
#include <sstream>

#include "tb/trace/wave_picture.h"

namespace racebeam {

TraceFiles::TraceFiles(const std::string& waveform, const std::string& picture,
                       const std::string& comment, VcdWriter& vcd)
    : waveform_(waveform), picture_name_(picture), comment_(comment), vcd_(vcd) {
  if (!waveform.empty()) wave_.emplace(waveform);
  if (!picture.empty()) picture_.emplace(picture);
  else vcd.stream(wave_->vcd(), comment);
}

void TraceFiles::commit(const GtkwWindow& window) {
  if (picture_) draw(vcd_.text(comment_, window.end));
  else vcd_.finish(window.end);
  if (wave_) {
    wave_->commit();
    write_text(gtkw_path(waveform_), gtkw_text(waveform_, vcd_, window));
  }
  if (picture_) picture_->commit();
}

void TraceFiles::draw(const std::string& dump) {
  VcdReader vcd(std::make_unique<std::istringstream>(dump), "the waveform");
  const std::string drawing =
      wave_picture(read_waves(vcd, [](const std::string&) { return true; }));
  picture_->write(drawing.data(), drawing.size());
  if (wave_) wave_->vcd().write(dump.data(), dump.size());
}

std::string TraceFiles::names() const {
  if (!wave_) return picture_name_;
  const std::string save = gtkw_path(waveform_);
  return picture_ ? waveform_ + ", " + save + " and " + picture_name_ : waveform_ + " and " + save;
}

}  // namespace racebeam
