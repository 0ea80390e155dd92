// How large a waveform will be, and how long it will take: said before a long one begins.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace racebeam {

/// What is known of a window before its first clock.
struct TraceSize {
  double bytes;    ///< of the VCD: within a factor of two of it
  double seconds;  ///< on a machine like that of the figures in docs/look-inside.md, with models

  /// Transactions of the tlm level.
  static TraceSize of_transactions(std::int64_t clocks);
  /// So many signals of the chip, with those of the beam, of a wire once; of an overview or not.
  /// `before`: clocks to be simulated before the window.
  static TraceSize of_signals(std::int64_t clocks, std::int64_t before, std::size_t signals,
                              bool overview);

  /// Whether somebody waits for it, or for the space.
  bool is_long() const;
  /// What is to be said if so many bytes are free where `output` is written; empty: it fits.
  std::string room_text(const std::string& output, double free) const;
  /// "about 1.4 GB and 12 minutes; as FST about 70 MB", for the file it goes to.
  std::string text(const std::string& output) const;
};

/// "1.4 GB", "310 MB", "4 KB".
std::string bytes_text(double bytes);

}  // namespace racebeam
