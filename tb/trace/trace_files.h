// TraceFiles: what `racebeam trace` leaves behind: a waveform with its save file, a picture, or
// both.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "tb/base/output_file.h"
#include "tb/wave/gtkw_file.h"
#include "tb/wave/vcd_writer.h"
#include "tb/wave/wave_file.h"

namespace racebeam {

class TraceFiles {
 public:
  /// `waveform` or `picture` may be empty, not both. A long window is streamed from `vcd`, which
  /// outlives this; one that is drawn is short, and stays in memory until the drawing is good. A
  /// save file that somebody made with GTKWave is kept. Throws OutputError.
  TraceFiles(const std::string& waveform, const std::string& picture, const std::string& comment,
             VcdWriter& vcd);

  /// Ends the files with the end of `window`: all are whole before the first gets its name, and the
  /// waveform gets it last. Until then, and if this throws, there is no waveform. Throws UsageError
  /// as read_waves() does, and OutputError.
  void commit(const GtkwWindow& window);

  /// "w.vcd and w.gtkw": what is written.
  std::string names() const;

 private:
  void draw(const std::string& dump);

  const std::string waveform_, picture_name_, comment_;
  VcdWriter& vcd_;
  std::optional<WaveFile> wave_;
  std::optional<OutputFile> save_, picture_;
};

}  // namespace racebeam
