// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/explain/voxel_explanation.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "sc/voxel/voxel_tracer.h"
#include "tb/host/voxel_show.h"
#include "tb/show/knobs_json.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;

constexpr double One = 1 << VoxelPositionFraction;  // of positions and of t

/// A state, and how long the pixel was in it.
struct Stay {
  const char* state;
  std::uint64_t clocks;
};

const char* word(voxel_step::deed done) {
  switch (done) {
    case voxel_step::Empty: return "empty";
    case voxel_step::Down: return "occupied, down";
    case voxel_step::Sample: return "occupied, sampled";
    case voxel_step::Hit: return "hit";
    case voxel_step::Leave: return "left";
  }
  return "";
}

const char* word(voxel_kind kind) {
  constexpr const char* Words[] = {"sky", "hit", "stopped by max_outer", "stopped by max_inner"};
  return Words[kind];
}

/// All that is said of a pixel.
struct Account {
  Account(const Run& run, const ExplainedPixel& p)
      : k(run.k), show(voxel_program_of(run.show.tables()), k) {
    show.go_to(p.frame);
    show.next();
    const voxel_world world(voxel_levels(k), show.columns());
    const voxel_ray ray{show.view().origin, voxel_direction(show.view(), p.column, p.row)};
    direction = ray.direction;
    voxel_walked walked;
    const voxel_steps note = [this](const voxel_step& step) { steps.push_back(step); };
    voxel_walk(world, k, ray, {k.max_outer, k.max_inner}, walked, &note);
    voxel_counters counters;
    pixel = voxel_tracer(k, world, show.palette()).draw(show.view(), p.column, p.row, counters);
    add_stays(walked, counters);
  }

  const voxel_knobs k;
  VoxelShow show;
  vec3 direction{};
  voxel_drawn pixel{};
  std::vector<voxel_step> steps;  // of the ray from the eye
  std::vector<Stay> stays;

 private:
  void add_stays(const voxel_walked& walked, const voxel_counters& counters) {
    constexpr std::uint64_t SetupClocks = 18;
    const auto memory = static_cast<std::uint64_t>(k.memory_clocks);
    const std::uint64_t fetches = walked.fetches(), stop = walked.column_reads - walked.samples;
    stays = {{"SETUP", SetupClocks},
             {"FETCH", fetches + memory * walked.words()},
             {"DOWN", walked.descents},
             {"EXIT", fetches - walked.descents},
             {"LEAF", walked.samples * (2 + memory)},
             {"MOVE", walked.moves},
             {"LIMIT", stop * (2 + memory)},
             {"SHADOW", counters.shadow_clocks},
             {"SHADE", counters.shade_clocks}};
  }
};

std::string place_text(const vec3& position) {
  return fmt::format("{:.3f} {:.3f} {:.3f}", position[0] / One, position[1] / One,
                     position[2] / One);
}

std::string row(const char* name, const std::string& value) {
  return fmt::format("{:<10} {}\n", name, value);
}

}  // namespace

Explainer::Size voxel_size_of(const Run& run, int) {
  const voxel_knobs k = run.k;
  return {k.picture_width, k.picture_height};
}

std::string voxel_explain_text(const Run& run, const ExplainedPixel& p, const std::string&) {
  const Account a(run, p);
  const int rgb = a.pixel.colour;
  std::string text =
      row("pixel",
          fmt::format("{},{} of picture {} of {}", p.column, p.row, p.frame, run.show.name())) +
      row("colour", fmt::format("{} {} {} of 255", rgb >> 16, rgb >> 8 & 255, rgb & 255)) +
      row("ray", word(a.pixel.end.kind));
  if (a.pixel.end.kind != VoxelSky) {
    text += row("at", place_text(a.pixel.end.position));
    if (a.k.shadows) text += row("light", a.pixel.shadowed ? "something is between" : "reaches it");
  }
  text += row("cost", fmt::format("{} clocks", a.pixel.clocks));
  for (const Stay& stay : a.stays)
    if (stay.clocks) text += fmt::format("{:>6} {}\n", stay.clocks, stay.state);
  text += fmt::format("\n{:>5}  {:<18} {:>9}  {}\n", "level", "voxel", "t", "");
  for (const voxel_step& step : a.steps)
    text += fmt::format("{:>5}  {:<18} {:>9.3f}  {}\n", step.level,
                        fmt::format("{} {} {}", step.voxel[0], step.voxel[1], step.voxel[2]),
                        static_cast<double>(step.t) / One, word(step.done));
  return text;
}

std::string voxel_explain_json(const Run& run, const ExplainedPixel& p, const std::string&) {
  const Account a(run, p);
  Json states = Json::array(), steps = Json::array();
  for (const Stay& stay : a.stays)
    if (stay.clocks) states.push_back({{"state", stay.state}, {"clocks", stay.clocks}});
  for (const voxel_step& step : a.steps)
    steps.push_back({{"level", step.level},
                     {"voxel", step.voxel},
                     {"word", step.place.word},
                     {"bit", step.place.bit},
                     {"t", static_cast<double>(step.t) / One},
                     {"outcome", word(step.done)}});
  const int rgb = a.pixel.colour;
  const Json json = {
      {"schema", "racebeam-explain-voxel"},
      {"version", 1},
      {"scene", run.show.name()},
      {"knobs", knobs_json(run.k)},
      {"picture", p.frame},
      {"column", p.column},
      {"row", p.row},
      {"rgb", {rgb >> 16, rgb >> 8 & 255, rgb & 255}},
      {"levels", 255},
      {"direction", a.direction},
      {"end", word(a.pixel.end.kind)},
      {"position", a.pixel.end.kind == VoxelSky ? Json() : Json(a.pixel.end.position)},
      {"shadowed", a.pixel.shadowed},
      {"clocks", a.pixel.clocks},
      {"states", states},
      {"steps", steps}};
  return json.dump(2) + "\n";
}

}  // namespace racebeam
