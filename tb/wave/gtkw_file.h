// A save file for GTKWave beside a waveform: groups by unit, number formats, colours, and the
// window.
//
// A small waveform is open as a whole. Of a large one `beam` and an overview are open, the tracer
// from its state to the FIFO; the units are folded. States are shown by their words, signals of
// their own (`state_q_name`), not by a translation file, which would be one more file to move
// about, and means nothing to other viewers.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "tb/wave/selection.h"
#include "tb/wave/vcd_writer.h"

namespace racebeam {

/// What is seen when the file is opened, in picoseconds.
struct GtkwWindow {
  std::uint64_t begin, end;
  std::uint64_t unit;                      ///< is wide enough to be read: a clock
  std::optional<std::uint64_t> marker;     ///< stands here, in sight; without one all is
  std::optional<DifferingPort> differs{};  ///< stands on top
};

/// The text of a save file that shows the signals of `vcd`, stored as `dump`: the port that differs
/// with the inputs of its unit, the beam, and a group for each unit, or the streams of
/// transactions. It finds `dump` beside itself, wherever both are moved.
std::string gtkw_text(const std::string& dump, const VcdWriter& vcd, const GtkwWindow& window);

/// Where it belongs: F.gtkw for F.vcd and F.fst.
std::string gtkw_path(const std::string& dump);

/// Whether a file lies at `path` that this program did not write: somebody saved it from GTKWave.
bool is_foreign_gtkw(const std::string& path);

}  // namespace racebeam
