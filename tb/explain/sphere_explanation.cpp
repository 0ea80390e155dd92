// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/explain/sphere_explanation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "tb/host/sphere_picture.h"
#include "tb/show/knobs_json.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;

const SphereProgram& program_of(const Run& run) {
  const scene_tables* const tables = run.show.tables();
  return tables ? *static_cast<const SphereProgram*>(tables) : builtin_sphere_program();
}

bool is_plane(int state) {
  return state == SpherePlane || state == SpherePlaneD || state == SpherePlaneT;
}

/// All that is said of a pixel.
struct Account {
  Account(const Run& run, const ExplainedPixel& pixel)
      : k(sphere_knobs(run.k).resolved()),
        core(core_before(program_of(run), k, pixel.frame)),
        steps(core->explain(pixel.column, pixel.row)),
        first_hit(core->first_hit(pixel.column, pixel.row)) {
    bool plane_hit = first_hit >= FirstPlane;  // whether LIGHT to ADD are about a plane
    for (const sphere_step& step : steps) {
      clocks += step.clocks;
      rays += step.state == SphereRay;
      shadow_rays += step.state == SphereLray;
      if (step.state == SphereRay) plane_hit = false;
      if (step.state == SpherePlaneT && step.what == "nearest") plane_hit = true;
      const bool of_plane =
          is_plane(step.state) ||
          (plane_hit &&
           (step.state == SphereLray || step.state == SphereLroot || step.state == SphereLdivide ||
            step.state == SphereNormal || step.state == SphereLambert || step.state == SphereAdd ||
            step.state == SphereReflect));
      objects.push_back(object(step.object, of_plane));
    }
  }

  std::string object(int number, bool plane) const {
    if (number < 0) return "";
    if (plane) return fmt::format("plane {}", number);
    return number == core->table().last_q ? "light" : fmt::format("sphere {}", number);
  }
  std::string met() const {
    if (first_hit == EyeInside) return "the eye is inside a sphere";
    if (first_hit == MeetsNothing) return "nothing";
    const bool plane = first_hit >= FirstPlane;
    return object(plane ? first_hit - FirstPlane : first_hit, plane);
  }
  std::uint64_t word() const { return steps.back().word; }
  std::array<int, 3> rgb(std::uint64_t word) const {
    const int full = (1 << k.colour_bits) - 1;
    return {static_cast<int>(word >> 2 * k.colour_bits) & full,
            static_cast<int>(word >> k.colour_bits) & full, static_cast<int>(word) & full};
  }
  bool is_light(std::uint64_t word) const { return word >> 3 * k.colour_bits & 1; }

  const sphere_knobs k;
  const std::unique_ptr<sphere_core> core;
  const std::vector<sphere_step> steps;
  const int first_hit;
  std::vector<std::string> objects;  // of the steps
  int clocks = 0, rays = 0, shadow_rays = 0;
};

std::string row(const char* name, const std::string& value) {
  return fmt::format("{:<10} {}\n", name, value);
}

std::string colour_text(const Account& a, std::uint64_t word) {
  const auto [red, green, blue] = a.rgb(word);
  return fmt::format("{:2} {:2} {:2}", red, green, blue);
}

std::string without_end_blanks(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

}  // namespace

Explainer::Size sphere_size(const Run& run, int picture) {
  const bool narrow = program_of(run).inputs_before(picture).narrow_q;
  return {sphere_knobs(run.k).columns(narrow), sphere_knobs::rows(narrow)};
}

std::string sphere_explain_text(const Run& run, const ExplainedPixel& p, const std::string&) {
  const Account a(run, p);
  const std::vector<std::string> states = sphere_state_words();
  std::string text =
      row("pixel",
          fmt::format("{},{} of picture {} of {}", p.column, p.row, p.frame, run.show.name())) +
      row("colour", fmt::format("{} of {}: word {:04x}{}", colour_text(a, a.word()),
                                (1 << a.k.colour_bits) - 1, a.word(),
                                a.is_light(a.word()) ? ", the light itself" : "")) +
      row("first hit", a.met()) +
      row("cost",
          fmt::format("{} clocks: {} rays, {} shadow rays", a.clocks, a.rays, a.shadow_rays)) +
      fmt::format("\n{:>6} {:>6}  {:<8}  {:<9}  {:<16}  {}\n", "clock", "clocks", "state", "object",
                  "so", "red green blue");
  int clock = 0;
  for (std::size_t n = 0; n < a.steps.size(); ++n) {
    const sphere_step& s = a.steps[n];
    const bool colour = s.state == SphereAdd || s.state == SphereNext;
    text += without_end_blanks(fmt::format("{:>6} {:>6}  {:<8}  {:<9}  {:<16}  {}", clock, s.clocks,
                                           states[static_cast<std::size_t>(s.state)], a.objects[n],
                                           s.what, colour ? colour_text(a, s.word) : ""));
    clock += s.clocks;
  }
  return text;
}

std::string sphere_explain_json(const Run& run, const ExplainedPixel& p, const std::string&) {
  const Account a(run, p);
  const std::vector<std::string> states = sphere_state_words();
  Json steps = Json::array();
  int clock = 0;
  for (std::size_t n = 0; n < a.steps.size(); ++n) {
    const sphere_step& s = a.steps[n];
    const bool colour = s.state == SphereAdd || s.state == SphereNext;
    steps.push_back({{"clock", clock},
                     {"clocks", s.clocks},
                     {"state", states[static_cast<std::size_t>(s.state)]},
                     {"object", a.objects[n].empty() ? Json() : Json(a.objects[n])},
                     {"outcome", s.what},
                     {"rgb", colour ? Json(a.rgb(s.word)) : Json()}});
    clock += s.clocks;
  }
  const Json json = {{"schema", "racebeam-explain-sphere"},
                     {"version", 1},
                     {"scene", run.show.name()},
                     {"knobs", knobs_json(run.k)},
                     {"picture", p.frame},
                     {"column", p.column},
                     {"row", p.row},
                     {"rgb", a.rgb(a.word())},
                     {"levels", (1 << a.k.colour_bits) - 1},
                     {"word", a.word()},
                     {"light", a.is_light(a.word())},
                     {"first_hit", a.met()},
                     {"clocks", a.clocks},
                     {"rays", a.rays},
                     {"shadow_rays", a.shadow_rays},
                     {"steps", steps}};
  return json.dump(2) + "\n";
}

}  // namespace racebeam
