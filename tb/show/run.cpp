// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/show/run.h"

#include <algorithm>
#include <optional>

#include "tb/base/errors.h"
#include "tb/base/nearest.h"
#include "tb/show/open_show.h"
#include "tb/show/set_knob.h"
#include "tb/twin/use_option.h"

namespace racebeam {

namespace {

// RTL has pins: it needs a chip that is wired.
std::string level_of(const RunOptions& options, const engine& built, bool wired) {
  const std::string& level = options.level;
  if (level.empty()) return wired || !options.units.empty() ? LevelSignal : built.levels.front();
  const std::vector<std::string> known(built.levels.begin(), built.levels.end());
  if (std::find(known.begin(), known.end(), level) == known.end())
    throw unknown_name("level", level, known);
  if (level == LevelTlm && !options.units.empty())
    throw UsageError(
        "--use puts RTL between the wires of --level signal; tlm has none: leave out --level tlm, "
        "or --use");
  return level;
}

}  // namespace

std::string RunOptions::set_text() const {
  std::string text = engine.empty() ? "" : " --engine " + engine;
  for (const std::string& assignment : assignments) text += " --set " + assignment;
  return text;
}

knob_values knobs_of(const Show& show, const std::vector<std::string>& assignments) {
  knob_values k = show.standard_knobs();
  set_knobs(show.engine(), k, assignments);
  if (const std::string why = show.objection(k); !why.empty()) throw UsageError(why);
  return k;
}

namespace {

/// By the engine that is asked for, if it can read the scene.
Show show_of(const RunOptions& options) {
  if (options.engine.empty()) return open_show(options.scene);
  const engine& shown = engine_named(options.engine);
  if (options.scene == "demo") return Show::built_in(shown);
  std::string why;
  if (std::optional<Show> show = open_show_for(shown, options.scene, why)) return *show;
  Show show = open_show(options.scene);
  expect_engine(show, options.engine);
  return show;
}

}  // namespace

Run open_run(const RunOptions& options, bool wired) {
  const Show show = show_of(options);
  return {show, level_of(options, show.engine(), wired), knobs_of(show, options.assignments)};
}

void use_units(Run& run, const std::vector<std::string>& units, bool traced, bool islands) {
  if (units.empty()) return;
  const UseOption use(run.show.engine(), run.k, run.show.tables(), traced);
  for (const std::string& choice : units) use.use(run.units, choice);
  use.join(run.units, islands);
}

}  // namespace racebeam
