// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/starter_sweep.h"

#include "tb/sweep/figures.h"

namespace racebeam {

std::string starter_sweep() {
  return std::string(R"(# A sweep for racebeam: is a stack of four entries enough?
# Measure it: racebeam sweep run FILE -o DIR; the same command goes on after any stop.
name = "stack against queue"
scenes = ["demo"]            # or scene files; each is reported apart

[frames]
sample = 256                 # of each point, spread over the show; "all": every frame
skip = ["*ray pattern*"]     # parts left out, by name: starved pixels do not show there
guard = 64                   # the base point's worst frames, beside the sample

[knobs]                      # a list: each value with each of the others; racebeam knobs has all
interval_stack_depth = [2, 3, 4, 5, 6, 8]   # the chip has 4
fifo_entries = { from = 8, to = 12, step = 2 }
bisection = "pow2"           # one value: the same in all points
where = "interval_stack_depth * 17 + fifo_entries * 8 <= 200"   # bits; what is larger is left out

[[point]]                    # beside them; what it does not name is as in the base
name = "unlimited"
knobs = { interval_stack_depth = 64, fifo_entries = 64 }

[base]                       # what all are compared with, and start from: the chip
knobs = {}

[search]
method = "grid"              # or "one-by-one", or "sobol" with points = 64 for many knobs, or
                             # "nsga2" with population = 32 and generations = 12 for their front
seed = 1

[goals]                      # "min", "max", or limits; beyond them a point is not wanted
picture_error = "min"
flip_flops = "min"
starved = { most = "1 %" }

[measure]
causes = false               # errors by cause: the figures error.give_up and so on
silicon = "generic"          # flip-flops and cells, by yosys; "off" without
timing = "off"               # area and longest path of whole chips: of the "front", or of "all"
pictures = [7223, "worst"]   # frames kept as pictures
reference = "geometry"       # what pictures are compared with: geometry, trace4, base

# Figures, for [goals] and for frames.until:
)") + figures_text("#   ");
}

}  // namespace racebeam
