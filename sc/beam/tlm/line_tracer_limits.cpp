// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/tlm/line_tracer_body.h"

namespace racebeam {

template line_counts trace_line<limit_knobs, false, false>(chip_core&, line_beam&,
                                                           const line_setting&, int);
template line_counts trace_line<limit_knobs, true, false>(chip_core&, line_beam&,
                                                          const line_setting&, int);

}  // namespace racebeam
