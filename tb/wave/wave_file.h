// WaveFile: a waveform's file, a VCD as it is written or an FST made of it by vcd2fst.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "tb/base/output_file.h"

namespace racebeam {

/// Whether `path` names a waveform: it ends with .vcd or .fst, in any case.
bool is_waveform(const std::string& path);
/// Whether it ends with .fst, in any case.
bool is_fst(const std::string& path);

/// Throws UsageError unless `path` is the name of a waveform, and MissingTool if it is to be an FST
/// and vcd2fst is not installed.
void check_waveform_name(const std::string& path);

class WaveFile {
 public:
  /// A path that ends with .fst gets an FST. Throws OutputError.
  explicit WaveFile(const std::string& path);
  ~WaveFile();

  /// Where to write the VCD.
  OutputFile& vcd() { return *vcd_; }
  /// Ends the writing, and makes the FST. Throws OutputError.
  void finish();
  /// Gives the file its name, after finish(). Throws OutputError.
  void commit();

 private:
  std::unique_ptr<OutputFile> vcd_, fst_;
  std::string made_of_;  // the VCD that an FST is made of
};

}  // namespace racebeam
