// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/beam_sources.h"

#include "sc/beam/engine.h"
#include "tb/view/beam_signal_source.h"
#include "tb/view/beam_tlm_source.h"

namespace racebeam {

namespace {

std::unique_ptr<FrameSource> make(const Run& run) {
  if (run.level != LevelTlm)
    return std::make_unique<SignalSource>(run.k, run.show.program(), run.units);
  const SceneFile* scene = run.show.scene();
  const bool wraps = !scene || scene->wrap || scene->overlap;
  return std::make_unique<TlmSource>(run.k, run.show.program(), wraps);
}

}  // namespace

SourceKind beam_sources() { return {beam_engine(), {LevelTlm, LevelSignal}, KeyHelp::Model, make}; }

}  // namespace racebeam
