// A save file for GTKWave beside a waveform: groups by unit, number formats, colours.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/trace/vcd_writer.h"

namespace racebeam {

/// The text of a save file that shows the signals of `vcd`, stored as `dump`: the beam, the chip's
/// wires, and a folded group for each unit; or the beam and the streams of transactions.
std::string gtkw_text(const std::string& dump, const VcdWriter& vcd);

/// Where it belongs: F.gtkw for F.vcd and F.fst.
std::string gtkw_path(const std::string& dump);

}  // namespace racebeam
