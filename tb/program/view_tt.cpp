// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/view_tt.h"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/base/interrupt.h"
#include "tb/base/output_file.h"
#include "tb/program/view_setting.h"
#include "tb/tt/tt_plugin.h"
#include "tb/tt/tt_remarks.h"
#include "tb/view/tt_source.h"

namespace racebeam {

namespace {

constexpr int UsualSoundPin = 7;

void refuse_scene_options(const ViewOptions& options) {
  refuse_with_tt(!options.scene.empty(), "the scene, or --tt");
  refuse_with_tt(!options.assignments.empty(), "--set, or --tt");
  refuse_with_tt(!options.units.empty(), "--use, or --tt");
  refuse_with_tt(!options.level.empty(), "--level, or --tt");
}

int sound_pin_of(const ViewOptions& options) {
  const long long pin = options.sound_pin.value_or(UsualSoundPin);
  if (pin < 0 || pin > 7)
    throw UsageError(fmt::format("--sound-pin {} is out of range; uio_out has 0..7", pin));
  return static_cast<int>(pin);
}

}  // namespace

int view_tt(const ViewOptions& options) {
  refuse_scene_options(options);
  const std::vector<std::string> keys = keys_to_press(options, KeyHelp::Tile);
  const Viewer::Options setting = viewer_options(options, MostTtFrames);
  const int sound_pin = sound_pin_of(options);
  const TtInputs inputs = tt_inputs(options);
  catch_interrupts();
  const TtProject project = read_tt_project(options.project, options.reading);
  TtRun run(project, tt_plugin(project, options.reading.trust), inputs);
  for (const std::string& remark : assumptions(project, run.found())) tell(remark);
  auto screen = open_screen(options);
  Viewer viewer({Show::of_tile(project.top, project.hash, MostTtFrames),
                 std::make_unique<TtSource>(run, sound_pin)},
                setting);
  viewer.control.state.paused = options.paused;
  const auto end = [&] {
    screen.reset();
    if (const std::string said = viewer.end(); !said.empty()) tell(said);
    if (options.record_inputs.empty()) return;
    write_text(options.record_inputs, run.inputs().text());
    tell("wrote " + options.record_inputs);
  };
  int code = ExitGood;
  try {
    code = run_view(viewer, *screen, keys);
  } catch (...) {
    end();  // what led to it can be replayed
    throw;
  }
  end();
  return code;
}

}  // namespace racebeam
