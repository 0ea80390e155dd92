// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/command.h"
#include "tb/program/command_bench.h"
#include "tb/program/command_capture.h"
#include "tb/program/command_claims.h"
#include "tb/program/command_compare.h"
#include "tb/program/command_delays.h"
#include "tb/program/command_doctor.h"
#include "tb/program/command_explain.h"
#include "tb/program/command_knobs.h"
#include "tb/program/command_render.h"
#include "tb/program/command_report.h"
#include "tb/program/command_scene.h"
#include "tb/program/command_shake.h"
#include "tb/program/command_signoff.h"
#include "tb/program/command_sweep.h"
#include "tb/program/command_trace.h"
#include "tb/program/command_units.h"
#include "tb/program/command_verify.h"
#include "tb/program/command_verilate.h"
#include "tb/program/command_view.h"

namespace racebeam {

const std::vector<Command>& command_table() {
  static const std::vector<Command> table = {
      render_row(),   view_row(),    explain_row(), trace_row(),  scene_row(),
      verify_row(),   capture_row(), shake_row(),   delays_row(), signoff_row(),
      verilate_row(), units_row(),   knobs_row(),   sweep_row(),  report_row(),
      compare_row(),  claims_row(),  bench_row(),   doctor_row(),
  };
  return table;
}

}  // namespace racebeam
