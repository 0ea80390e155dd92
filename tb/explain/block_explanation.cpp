// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/explain/block_explanation.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "sc/block/block_machine.h"
#include "tb/host/block_program.h"
#include "tb/show/knobs_json.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;

/// A stay in a state.
struct Step {
  const char* state;
  int clocks;
  std::string object;
  std::string rgb;
};

std::string colour_text(const vec3& colour) {
  constexpr double One = 1 << BlockFraction, Full = 256;  // as it is stored, before the limit
  return fmt::format("{:5.1f} {:5.1f} {:5.1f}", colour[0] / One * Full, colour[1] / One * Full,
                     colour[2] / One * Full);
}

/// All that is said of a pixel.
struct Account {
  Account(const Run& run, const ExplainedPixel& p)
      : k(run.k), block(p.row / BlockSide * (k.columns() / BlockSide) + p.column / BlockSide) {
    const block_tables tables = tables_of(block_program_of(run.show.tables()), k, p.frame);
    block_machine machine(k);
    block_renderer::notes notes;
    machine.note(&notes);
    machine.draw(tables);
    dealt = notes.blocks[static_cast<std::size_t>(block)];
    begin = notes.begins[static_cast<std::size_t>(p.row * k.columns() + p.column)];
    const std::int64_t start =
        machine.store().clock() - static_cast<std::int64_t>(machine.counters().clocks);
    dealt.clock -= start;
    begin -= start;
    pixel = block_rays(k, converted(tables, k)).explain(p.column, p.row);
    if (!pixel.cleared) add_steps();
  }

  static std::string object(int sphere) {
    return sphere < 0 ? "" : fmt::format("sphere {}", sphere);
  }
  std::string first_hit() const {
    return pixel.passes.empty() || pixel.passes.front().sphere < 0
               ? "nothing"
               : object(pixel.passes.front().sphere);
  }

  const block_knobs k;
  const int block;
  block_renderer::dealt dealt{};  // clock of the picture
  std::int64_t begin = 0;         // of the pixel, too
  block_pixel pixel;
  std::vector<Step> steps;

 private:
  void add_steps() {
    steps.push_back({"PIXEL", k.normalise_clocks(), "", ""});
    for (const block_pass& pass : pixel.passes) {
      steps.push_back({"GROUP", pass.groups, "", ""});
      if (pass.near) steps.push_back({"NEAR", pass.near, object(pass.sphere), ""});
      steps.push_back({"DECIDE", 1, "", ""});
      if (pass.sphere >= 0)
        steps.push_back({"SHADE", k.shade_clocks(), object(pass.sphere), colour_text(pass.colour)});
      if (pass.shadow) steps.push_back({"SHADOW", pass.shadow, "", pass.dark ? "dark" : "lit"});
    }
    steps.push_back({"STORE", 1, "", ""});
  }
};

std::string row(const char* name, const std::string& value) {
  return fmt::format("{:<10} {}\n", name, value);
}

}  // namespace

Explainer::Size block_size_of(const Run& run, int) {
  const block_knobs k = run.k;
  return {k.columns(), k.rows()};
}

std::string block_explain_text(const Run& run, const ExplainedPixel& p, const std::string&) {
  const Account a(run, p);
  const auto& [red, green, blue] = a.pixel.rgb;
  std::string text =
      row("pixel",
          fmt::format("{},{} of picture {} of {}", p.column, p.row, p.frame, run.show.name())) +
      row("colour", fmt::format("{} {} {} of 255", red, green, blue)) +
      row("first hit", a.first_hit()) +
      row("block",
          fmt::format("{}, by core {}, dealt in clock {}", a.block, a.dealt.core, a.dealt.clock));
  if (a.pixel.cleared)
    return text + row("cost", "no ray: no sphere can be in its block, which was cleared");
  text += row("cost", fmt::format("{} clocks from clock {} on: {} passes", a.pixel.clocks, a.begin,
                                  a.pixel.passes.size())) +
          fmt::format("\n{:>6} {:>6}  {:<8}  {:<10}{}\n", "clock", "clocks", "state", "object",
                      " red  green  blue");
  int clock = 0;
  for (const Step& s : a.steps) {
    std::string line =
        fmt::format("{:>6} {:>6}  {:<8}  {:<10}{}", clock, s.clocks, s.state, s.object, s.rgb);
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
    clock += s.clocks;
  }
  return text;
}

std::string block_explain_json(const Run& run, const ExplainedPixel& p, const std::string&) {
  const Account a(run, p);
  Json steps = Json::array();
  int clock = 0;
  for (const Step& s : a.steps) {
    steps.push_back({{"clock", clock},
                     {"clocks", s.clocks},
                     {"state", s.state},
                     {"object", s.object.empty() ? Json() : Json(s.object)}});
    clock += s.clocks;
  }
  const Json json = {{"schema", "racebeam-explain-block"},
                     {"version", 1},
                     {"scene", run.show.name()},
                     {"knobs", knobs_json(run.k)},
                     {"picture", p.frame},
                     {"column", p.column},
                     {"row", p.row},
                     {"rgb", a.pixel.rgb},
                     {"levels", 255},
                     {"first_hit", a.first_hit()},
                     {"block", a.block},
                     {"core", a.dealt.core},
                     {"dealt", a.dealt.clock},
                     {"cleared", a.pixel.cleared},
                     {"begin", a.begin},
                     {"clocks", a.pixel.clocks},
                     {"passes", a.pixel.passes.size()},
                     {"steps", steps}};
  return json.dump(2) + "\n";
}

}  // namespace racebeam
