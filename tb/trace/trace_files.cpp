// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/trace/trace_files.h"

#include <memory>
#include <sstream>
#include <vector>

#include "tb/base/console.h"
#include "tb/wave/wave_picture.h"

namespace racebeam {

TraceFiles::TraceFiles(const std::string& waveform, const std::string& picture,
                       const std::string& comment, VcdWriter& vcd)
    : waveform_(waveform), picture_name_(picture), comment_(comment), vcd_(vcd) {
  if (!waveform.empty()) {
    wave_.emplace(waveform);
    if (const std::string save = gtkw_path(waveform); !is_foreign_gtkw(save)) save_.emplace(save);
  }
  if (!picture.empty()) picture_.emplace(picture);
  else vcd.stream(wave_->vcd(), comment);
}

void TraceFiles::commit(const GtkwWindow& window) {
  if (picture_) draw(vcd_.text(comment_, window.end));
  else vcd_.finish(window.end);
  if (save_) {
    const std::string text = gtkw_text(waveform_, vcd_, window);
    save_->write(text.data(), text.size());
    save_->finish(text.size());
  }
  if (picture_) picture_->finish();
  if (wave_) wave_->finish();
  if (save_) save_->commit();
  if (picture_) picture_->commit();
  if (wave_) wave_->commit();
  if (wave_ && !save_)
    tell("kept " + gtkw_path(waveform_) + ", which is not ours; remove it to get a new one");
}

void TraceFiles::draw(const std::string& dump) {
  VcdReader vcd(std::make_unique<std::istringstream>(dump), "the waveform");
  const std::string drawing =
      wave_picture(read_waves(vcd, [](const std::string&) { return true; }));
  picture_->write(drawing.data(), drawing.size());
  if (wave_) wave_->vcd().write(dump.data(), dump.size());
}

std::string TraceFiles::names() const {
  std::vector<std::string> all;
  if (wave_) all.push_back(waveform_);
  if (save_) all.push_back(gtkw_path(waveform_));
  if (picture_) all.push_back(picture_name_);
  std::string text = all[0];
  for (std::size_t n = 1; n < all.size(); ++n)
    text += (n + 1 < all.size() ? ", " : " and ") + all[n];
  return text;
}

}  // namespace racebeam
