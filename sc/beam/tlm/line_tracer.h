// line_tracer: the tracer of a line in one loop, from its first clock up to the last but one of the
// line.
//
// Units: ray_stepper, subdivider, stacks, decision_datapath and the room; the same core functions
// as in chip_core, in the same order, with registers in local variables. Three things are skipped,
// all of them clocks that are known to change nothing or to repeat: waiting for a full FIFO, dr2
// following the beam in the lock effect, and whole rounds of the tracer after line_done; all of
// these where lines are wanted apart.
//
// `Knobs` says which knobs are known when this is compiled: their arithmetic folds. It stands for a
// chip only where Knobs::of(k) == k: a knob that it does not take from `k` is the taped-out chip's.
// With `Pattern` the lock effect may hold; with `Watch` there is an observer.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

#include "sc/beam/chip_core.h"
#include "sc/beam/scene_program.h"
#include "sc/beam/tlm/line_beam.h"
#include "sc/beam/tlm/line_setting.h"

namespace racebeam {

/// The taped-out chip.
struct chip_knobs {
  static constexpr knobs values{};
  static constexpr const knobs& of(const knobs&) { return values; }
};
/// The taped-out chip with what a scene file sets.
struct scene_knobs {
  static constexpr knobs of(const knobs& k) {
    return program_knobs{k.corner_bits, k.navigator_bits, k.portals_per_face}.fitted({});
  }
};
/// The taped-out chip with other limits: of what it stores, of its products and of time.
struct limit_knobs {
  static constexpr knobs of(const knobs& k) {
    knobs of = {};
    of.interval_stack_depth = k.interval_stack_depth;
    of.face_stack_depth = k.face_stack_depth;
    of.max_room_depth = k.max_room_depth;
    of.fifo_entries = k.fifo_entries;
    of.fifo_short_length_bits = k.fifo_short_length_bits;
    of.fifo_merge = k.fifo_merge;
    of.hurry_threshold = k.hurry_threshold;
    of.corner_factor_bits = k.corner_factor_bits;
    of.partial_products_cut = k.partial_products_cut;
    of.interlace = k.interlace;
    of.clocks_per_pixel = k.clocks_per_pixel;
    of.speed = k.speed;
    of.head_start = k.head_start;
    return of;
  }
};
/// Any.
struct any_knobs {
  static knobs of(const knobs& k) { return k; }
};

/// Runs clocks `t` .. size - 2 of a line; `t` is the first with the camera in RUN. Registers of
/// `chip` but those of interval_fifo, which the beam owns, and vga_timing are then those of the
/// last clock. Returns the counts up to line_done.
template <class Knobs, bool Pattern, bool Watch>
line_counts trace_line(chip_core& chip, line_beam& beam, const line_setting& line, int t);

extern template line_counts trace_line<chip_knobs, false, false>(chip_core&, line_beam&,
                                                                 const line_setting&, int);
extern template line_counts trace_line<chip_knobs, true, false>(chip_core&, line_beam&,
                                                                const line_setting&, int);
extern template line_counts trace_line<scene_knobs, false, false>(chip_core&, line_beam&,
                                                                  const line_setting&, int);
extern template line_counts trace_line<scene_knobs, true, false>(chip_core&, line_beam&,
                                                                 const line_setting&, int);
extern template line_counts trace_line<limit_knobs, false, false>(chip_core&, line_beam&,
                                                                  const line_setting&, int);
extern template line_counts trace_line<limit_knobs, true, false>(chip_core&, line_beam&,
                                                                 const line_setting&, int);
extern template line_counts trace_line<any_knobs, false, false>(chip_core&, line_beam&,
                                                                const line_setting&, int);
extern template line_counts trace_line<any_knobs, true, false>(chip_core&, line_beam&,
                                                               const line_setting&, int);
extern template line_counts trace_line<any_knobs, false, true>(chip_core&, line_beam&,
                                                               const line_setting&, int);
extern template line_counts trace_line<any_knobs, true, true>(chip_core&, line_beam&,
                                                              const line_setting&, int);

}  // namespace racebeam
