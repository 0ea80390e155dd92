// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/explain/ray_walk.h"

#include <algorithm>

#include "sc/beam/tlm/chip_lines.h"

namespace racebeam {

namespace {

/// The chip in the tracer's first clock of a line.
chip_core at_line(const Show& show, const knobs& k, int frame, int y) {
  chip_lines lines({k, show.program(), false, false, nullptr});
  lines.deposit(frame);
  while (lines.next_line() != y) lines.run_line();
  chip_core chip = lines.registers();
  while (!chip.camera_unit.run()) chip.clock_video(true, k);
  return chip;
}

vec3 half_size(const chip_core& chip, const knobs& k) {
  const int room = chip.decision_datapath.room_q;
  if (chip.program) return scene_rom_core::geometry(*chip.program, room).half_size;
  const int flags = chip.sequencer.comb({true, false, false, 0}, k).scene_flags;
  return scene_core::geometry(flags, room).half_size;
}

RayQuestion question(const chip_core& chip, const knobs& k) {
  const decision_datapath_core& d = chip.decision_datapath;
  const int dec = d.decide(chip.ray_stepper.dr1_q, k);
  TracerStep step{};
  step.clocks = 1;
  step.state = StateLeft;
  step.first = step.last = step.idx2 = chip.subdivider.idx2_q;
  step.room = d.room_q;
  step.depth = d.depth_q;
  step.level = d.level_q;
  step.face = d.face_q;
  step.y_first = d.dom_q;
  step.decision = true;
  step.answer = d.mask() == 1 ? dec & 1 : dec >> 1;
  return {step, d.corner_q, half_size(chip, k)};
}

}  // namespace

vec3 LineRays::ray(int pixel, const knobs& k) const {
  ray_stepper_core stepper;
  stepper.dr2_q = dr_0;
  for (int at = 0; at != pixel;) {
    ray_stepper_core::inputs in{};
    in.delta = ddr;
    in.step = true;
    in.neg = at > pixel;
    in.step_size = closest_power_of_two(2 * (pixel - at));
    in.idx2 = at;
    stepper.clock(in, k);
    at += in.neg ? -in.step_size : in.step_size;
  }
  return stepper.dr2_q;
}

LineRays line_rays(const Show& show, const knobs& k, int frame, int y) {
  const chip_core chip = at_line(show, k, frame, y);
  return {chip.ray_stepper.dr1_q, chip.camera_unit.ddr_q};
}

RayWalk::RayWalk(const Show& show, const knobs& k, int frame, int y, int pixel) {
  knobs patient = k;
  patient.hurry_threshold = -1;
  chip_core chip = at_line(show, k, frame, y);
  ray = LineRays{chip.ray_stepper.dr1_q, chip.camera_unit.ddr_q}.ray(pixel, k);
  chip.ray_stepper.dr1_q = chip.ray_stepper.dr2_q = ray;
  subdivider_core& s = chip.subdivider;
  s.i1_q = s.i2_q = s.idx2_q = pixel;
  const decision_datapath_core& d = chip.decision_datapath;
  while (!d.wall_q) {
    if (!d.second_q) questions.push_back(question(chip, patient));
    chip.clock_video(true, patient);
  }
  wall = d.hit_face_q;
}

vec3 RayWalk::magnitudes() const {
  vec3 size;
  for (int a = 0; a < 3; ++a) size[a] = negative(a) ? ~ray[a] : ray[a];
  return size;
}

std::size_t RayWalk::last_room() const {
  const auto is_portal = [](const RayQuestion& q) { return q.step.depth > 0 && q.step.level < 4; };
  auto at = std::find_if(questions.rbegin(), questions.rend(), is_portal);
  if (at == questions.rend()) at = questions.rbegin();
  while (at->step.level != 6) ++at;
  return questions.rend() - at - 1;
}

}  // namespace racebeam
