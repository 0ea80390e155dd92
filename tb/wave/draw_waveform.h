// `racebeam trace WAVE.vcd --picture F.svg`: a waveform that is there already, as a picture.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/wave/selection.h"

namespace racebeam {

/// Throws UsageError unless `picture` is the name of an SVG file.
void check_picture_name(const std::string& picture);

/// Draws the VCD `dump` into the file `picture`. Returns the exit code. Throws UsageError as
/// read_waves() does and if `dump` cannot be read; OutputError.
int draw_waveform(const std::string& dump, const std::string& picture,
                  const TraceSelection& selection);

}  // namespace racebeam
