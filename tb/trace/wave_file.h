// WaveFile: a waveform's file, a VCD as it is written or an FST made of it by vcd2fst.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "tb/output_file.h"

namespace racebeam {

/// Whether `path` names a waveform: it ends with .vcd or .fst.
bool is_waveform(const std::string& path);

/// Throws MissingTool if vcd2fst is not installed.
void need_vcd2fst();

class WaveFile {
 public:
  /// A path that ends with .fst gets an FST. Throws OutputError.
  explicit WaveFile(const std::string& path);
  ~WaveFile();

  /// Where to write the VCD.
  OutputFile& vcd() { return *vcd_; }
  /// Ends the file. Throws OutputError.
  void commit();

 private:
  std::unique_ptr<OutputFile> vcd_, fst_;
  std::string made_of_;  // the VCD that an FST is made of
};

}  // namespace racebeam
