// In how many pixels the chip differs from the golden tracers, and why.
//
// A chain of pictures leads from the chip as it was run to trace_4: each link switches one of the
// chip's limits off, at the tlm level. A pixel that differs from trace_4 is put down to the last
// link that changes it, so that these numbers add up to the difference. Behind trace_4 three more
// causes are counted as what they are: trace_4 against trace_2, trace_2 with corners of any size,
// and that against geometry. A second chain, from trace_4 to geometry, splits the rounding of rays
// by the knobs that there are for it; its three numbers add up to that difference. What is left
// over must be nothing.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tb/golden/golden_picture.h"
#include "tb/judge/error_links.h"
#include "tb/show/show.h"

namespace racebeam {

/// All causes: the first golden_limits() of them lead to trace_4, in the order in which they are
/// switched off.
const std::vector<ErrorCause>& golden_causes();
int golden_limits();

/// How far pictures are from those of an engine's only golden tracer.
struct PictureErrors {
  std::uint64_t pixels = 0;      ///< compared; 0: the engine has several golden tracers
  std::uint64_t differing = 0;   ///< of them
  std::uint64_t by_more = 0;     ///< by more than one level in some channel
  std::uint64_t wrong_hits = 0;  ///< pixels whose first ray meets something else
  std::uint64_t squares = 0;     ///< of the errors of all channels, in levels
  int most = 0;                  ///< the highest level

  PictureErrors& operator+=(const PictureErrors& more);
  double rmse() const;  ///< levels
  double psnr() const;  ///< dB; infinite if nothing differs
};

/// Of one frame, or sums over several.
struct GoldenCounts {
  GoldenCounts();
  GoldenCounts& operator+=(const GoldenCounts& more);

  std::array<int, 3> by_tracer{};  ///< pixels that differ from each GoldenTracer's picture
  std::vector<int> by_cause;       ///< pixels, by golden_causes()
  PictureErrors errors;            ///< instead, of an engine with one golden tracer
};

/// What a comparison of one frame found.
struct GoldenReport {
  GoldenCounts counts;
  GoldenPicture difference;  ///< see golden_difference_picture()
};

/// Judges `chip`, the picture of a frame of a show rendered with `k`.
GoldenReport golden_compare(const Show& show, int frame, const knobs& k, const GoldenPicture& chip);

/// The chip's picture dimmed. Bright are the pixels that differ: yellow from trace_4, else cyan
/// from trace_2, else magenta from geometry.
GoldenPicture golden_difference_picture(const GoldenPicture& chip,
                                        const std::array<GoldenPicture, 3>& by_tracer);

}  // namespace racebeam
