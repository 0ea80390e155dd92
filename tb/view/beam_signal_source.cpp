// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/beam_signal_source.h"

#include <algorithm>

namespace racebeam {

namespace {

SignalBench::Options options_of(const knobs& k, const scene_program* program,
                                const unit_choices& units, BeamWatch* watch) {
  SignalBench::Options options;
  options.k = k;
  options.program = program;
  options.units = units;
  options.watch = watch;
  return options;
}

}  // namespace

SignalSource::SignalSource(const knobs& k, const scene_program* program, const unit_choices& units)
    : BeamSource(k), bench_(options_of(k, program, units, &watch_)) {}

void SignalSource::seek(int frame) {
  if (watch_.seen() > 0 && !watch_.whole()) advance(clocks_left());
  bench_.seek(frame);
}

int SignalSource::advance(int clocks) {
  const int count = std::min(clocks, clocks_left());
  bench_.advance(count);
  return count;
}

}  // namespace racebeam
