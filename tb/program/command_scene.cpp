// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/command_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <variant>

#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/base/output_file.h"
#include "tb/judge/line_estimate.h"
#include "tb/program/common_options.h"
#include "tb/scene/plan_drawing.h"
#include "tb/scene/scene_check.h"
#include "tb/scene/scene_kinds.h"
#include "tb/scene/scene_sight.h"
#include "tb/show/knobs_json.h"
#include "tb/show/open_show.h"

namespace racebeam {

namespace {

constexpr int FramesPerSecond = 60;

nlohmann::ordered_json timeline(const SceneFile& scene) {
  nlohmann::ordered_json shots = nlohmann::ordered_json::array();
  for (const Shot& shot : scene.shots)
    shots.push_back({{"frame", shot.frame}, {"name", shot.name}});
  return shots;
}

nlohmann::ordered_json summary(const SceneFile& scene,
                               const std::vector<std::string>& assignments) {
  const Show show(scene, "");
  const knobs k = knobs_of(show, assignments);
  const SceneWidths widths = scene_widths(scene);
  const LineEstimate line = estimate_worst_line(show, k);
  return {{"schema", "racebeam-scene"},
          {"version", 1},
          {"name", scene.name},
          {"rooms", scene.rooms.size()},
          {"portals", count_portals(scene)},
          {"portals_per_face", widths.portals_per_face},
          {"shots", scene.shots.size()},
          {"frames", scene.frames},
          {"timeline", timeline(scene)},
          {"deepest_view", deepest_view(scene)},
          {"room_bits", widths.room_bits},
          {"corner_bits", k.corner_bits},
          {"corner_bits_needed", widths.corner_bits},
          {"camera_bits", widths.camera_bits},
          {"worst_line",
           {{"clocks", line.clocks},
            {"budget", LineEstimate::budget(k)},
            {"intervals", line.intervals},
            {"frame", line.frame},
            {"y", line.y}}},
          {"knobs", knobs_json(k)}};
}

std::string table(const nlohmann::ordered_json& scene) {
  std::string text;
  const auto row = [&](const char* name, const std::string& value) {
    text += fmt::format("{:<14} {}\n", name, value);
  };
  const auto number = [](const nlohmann::ordered_json& value) { return value.get<int>(); };
  row("scene", scene["name"].get<std::string>());
  row("rooms", std::to_string(number(scene["rooms"])));
  row("portals", fmt::format("{}, up to {} in a face", number(scene["portals"]),
                             number(scene["portals_per_face"])));
  row("timeline",
      fmt::format("{} frames ({:.1f} s), {} shots", number(scene["frames"]),
                  number(scene["frames"]) / double(FramesPerSecond), number(scene["shots"])));
  row("deepest view", fmt::format("{} portals", number(scene["deepest_view"])));
  const int needed = number(scene["corner_bits_needed"]), built = number(scene["corner_bits"]);
  row("widths", fmt::format("room {}, corner {}, camera {} bits", number(scene["room_bits"]), built,
                            number(scene["camera_bits"])));
  if (needed > built)
    row("", fmt::format("far corners wrap: {} corner bits would hold them", needed));
  const nlohmann::ordered_json& line = scene["worst_line"];
  row("worst line",
      fmt::format("about {} of {} clocks, {} intervals (frame {}, y {}); an estimate",
                  number(line["clocks"]), number(line["budget"]), number(line["intervals"]),
                  number(line["frame"]), number(line["y"])));
  for (const nlohmann::ordered_json& shot : scene["timeline"])
    if (shot["name"] != "")
      row(fmt::format("frame {}", number(shot["frame"])).c_str(), shot["name"].get<std::string>());
  return text;
}

/// The same of a scene that has facts.
nlohmann::ordered_json summary(const Show& show, const AnyScene& scene, const knob_values& k) {
  nlohmann::ordered_json json = {{"schema", "racebeam-scene"},
                                 {"version", 1},
                                 {"engine", show.engine().name},
                                 {"name", show.name()}};
  for (const SceneFact& fact : scene.facts())
    std::visit([&](const auto& value) { json[fact.name] = value; }, fact.value);
  json["knobs"] = knobs_json(k);
  return json;
}

std::string facts_table(const nlohmann::ordered_json& scene) {
  std::string text = fmt::format("{:<14} {}, for {}\n", "scene", scene["name"].get<std::string>(),
                                 scene["engine"].get<std::string>());
  for (const auto& [name, value] : scene.items()) {
    if (value.is_object() || name == "schema" || name == "version" || name == "engine" ||
        name == "name")
      continue;
    std::string title = name;
    std::replace(title.begin(), title.end(), '_', ' ');
    text += fmt::format("{:<14} {}\n", title,
                        value.is_string()    ? value.get<std::string>()
                        : value.is_boolean() ? (value.get<bool>() ? "yes" : "no")
                                             : value.dump());
  }
  return text;
}

}  // namespace

int command_scene_check(const SceneOptions& options) {
  std::string warnings;
  const auto scene = load_any_scene(options.file, &warnings);
  std::fputs(warnings.c_str(), stderr);
  print("good: " + scene->counts() + "\n");
  return ExitGood;
}

int command_scene_show(const SceneOptions& options) {
  const std::shared_ptr<const AnyScene> scene = load_any_scene(options.file);
  const Show show(scene, "");
  const bool has_facts = !scene->facts().empty();
  if (!has_facts) expect_rooms(show, "scene show");
  const nlohmann::ordered_json json =
      has_facts ? summary(show, *scene, knobs_of(show, options.run.assignments))
                : summary(*show.scene(), options.run.assignments);
  using Json = nlohmann::ordered_json;
  print(options.json ? json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"
        : has_facts  ? facts_table(json)
                     : table(json));
  return ExitGood;
}

int command_scene_plan(const SceneOptions& options) {
  const std::string kind = extension_of(options.picture);
  if (kind != ".png" && kind != ".svg")
    throw UsageError("scene plan writes .png or .svg; rename " + options.picture);
  const SceneFile scene = load_scene(options.file, "scene plan");
  const PlanDrawing plan = draw_plan(scene, kind == ".svg" ? PlanFormat::Svg : PlanFormat::Png);
  write_text(options.picture, plan.bytes);
  tell(fmt::format("wrote {}, {} x {} pixels: each storey from above, and all from the south",
                   options.picture, plan.width, plan.height));
  return ExitGood;
}

int command_scene_new(const SceneOptions& options) {
  std::error_code ignored;
  if (std::filesystem::exists(std::filesystem::symlink_status(options.file, ignored)))
    throw UsageError(options.file + " exists; choose another name");
  const engine& shown =
      options.engine.empty() ? scene_kinds().front().engine : engine_named(options.engine);
  const SceneKind& kind = scene_kind_of(shown);
  if (!kind.starter)
    throw UsageError(std::string("there is no scene to start from for ") + shown.name);
  write_text(options.file, kind.starter());
  tell("wrote " + options.file + "; try `racebeam " +
       (&kind == &scene_kinds().front() ? "scene plan " + options.file + " -o plan.png`"
                                        : "render " + options.file + " -o first.png`"));
  return ExitGood;
}

namespace {

void add_notes_options(const CommandOptions& notes, SceneOptions& options) {
  notes.add_option("scene", options.scenes, "Scene files, or demo").required().type_name("SCENE");
  notes.add_option("-o,--output", options.notes, "Markdown")
      .required()
      .type_name("FILE.md")
      .check(not_empty);
  add_set_option(notes, options.run);
  add_number(notes, "--frames", options.frames, "Frames of each scene, spread evenly over it",
             is_number_in("--frames", 1, 1000))
      .capture_default_str();
}

}  // namespace

Command scene_row() {
  return {
      "scene", "Check, show, draw, start and judge scene files", "Write", "scene new my.toml",
      [](const CommandOptions& command) -> RunCommand {
        const auto options = std::make_shared<SceneOptions>();
        const auto chosen = std::make_shared<int (*)(const SceneOptions&)>();
        const auto add = [&](const char* name, const char* help, int (*run)(const SceneOptions&)) {
          return command.add_subcommand(name, help, [chosen, run] { *chosen = run; });
        };
        const auto add_of_file = [&](const char* name, const char* type, const char* help,
                                     int (*run)(const SceneOptions&)) {
          const CommandOptions one = add(name, help, run);
          one.add_option("file", options->file, "Scene file (TOML)").required().type_name(type);
          return one;
        };
        add_of_file("check", "SCENE", "List all faults with line, column and help",
                    command_scene_check);
        const CommandOptions show =
            add_of_file("show", "SCENE", "Counts, widths and an estimate of the worst line",
                        command_scene_show);
        add_set_option(show, options->run);
        show.add_flag("--json", options->json, "JSON on stdout instead of the text");
        add_of_file("plan", "SCENE", "Draw rooms, portals and the camera's way", command_scene_plan)
            .add_option("-o,--output", options->picture, "Picture: FILE.png or FILE.svg")
            .required()
            .type_name("FILE")
            .check(not_empty);
        add_engine_option(
            add_of_file("new", "FILE", "Write a scene to start from", command_scene_new),
            options->engine, "A scene for this engine");
        add_notes_options(add("notes",
                              "Counters of some frames, and why the chip does not show the "
                              "ideal pictures",
                              command_scene_notes),
                          *options);
        return [options, chosen](const std::vector<std::string>&) { return (*chosen)(*options); };
      }};
}

}  // namespace racebeam
