// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/command_compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/base/interrupt.h"
#include "tb/base/output_file.h"
#include "tb/base/progress.h"
#include "tb/picture/picture_format.h"
#include "tb/program/common_options.h"
#include "tb/program/compare_sheet.h"
#include "tb/report/expected_figures.h"
#include "tb/scene/engines.h"
#include "tb/show/open_show.h"
#include "tb/show/set_knob.h"

namespace racebeam {

namespace {

constexpr int MaxPictures = 1000;

std::vector<const engine*> engines_of(const CompareOptions& options) {
  if (options.engines.empty()) return engines();
  std::vector<const engine*> named;
  for (const std::string& name : options.engines) named.push_back(&engine_named(name));
  return named;
}

/// Each "E.knob=value" is for an engine that is compared, which has such a knob.
void check_assignments(const CompareSetting& setting) {
  for (const std::string& one : setting.assignments) {
    const auto dot = one.find('.');
    if (dot == std::string::npos || dot > one.find('='))
      throw UsageError("--set '" + one +
                       "' is not of the form ENGINE.KNOB=VALUE, as in --set block.cores=1");
    const engine& built = engine_named(one.substr(0, dot));
    if (std::find(setting.engines.begin(), setting.engines.end(), &built) == setting.engines.end())
      throw UsageError(fmt::format("--set {}: {} is not compared; add --engine {}", one, built.name,
                                   built.name));
    knob_values k = built.standard(nullptr);
    set_knob(k, one.substr(dot + 1));
  }
}

std::vector<CompareGroup> groups_of(const CompareOptions& options) {
  if (options.scenes.empty()) return common_groups();
  std::vector<CompareGroup> groups;
  for (const std::string& scene : options.scenes) {
    // A scene of the table has its settings.
    const auto& known = common_groups();
    const auto at = std::find_if(known.begin(), known.end(),
                                 [&](const CompareGroup& group) { return group.name == scene; });
    groups.push_back(at != known.end() ? *at : CompareGroup{scene, {{scene}}});
  }
  return groups;
}

void write_picture(const std::string& path, const RgbImage& picture) {
  const PictureFormat* const format = format_of_file(path);
  const std::string bytes = picture_bytes(format ? *format : picture_formats().front(), picture);
  OutputFile file(path);
  file.write(bytes.data(), bytes.size());
  file.commit();
}

/// "common_balls_block"
std::string stem_of(const ComparedGroup& group, const ComparedCell& cell) {
  std::string stem = group.name + "_" + cell.engine;
  std::replace_if(
      stem.begin(), stem.end(), [](char c) { return c == '/' || c == ' ' || c == '.'; }, '_');
  return stem;
}

void write_folder(const std::string& folder, const std::vector<ComparedGroup>& groups) {
  make_folder(folder);
  const std::filesystem::path in = folder;
  for (const ComparedGroup& group : groups)
    for (const ComparedEngine& column : group.engines) {
      if (!column.cell) continue;
      const ComparedCell& cell = *column.cell;
      const std::string stem = stem_of(group, cell);
      write_picture((in / (stem + ".png")).string(), RgbImage(cell.picture));
      if (cell.ideal.width > 0)
        write_picture((in / (stem + "_difference.png")).string(),
                      difference_picture(cell.picture, cell.ideal));
    }
  write_text((in / "compare.json").string(), compared_json(groups));
}

std::string markdown_of(const std::vector<ComparedGroup>& groups) {
  std::string text;
  for (const ComparedGroup& group : groups)
    text += (text.empty() ? "" : "\n") + compared_markdown(group);
  return text;
}

}  // namespace

int command_compare(const CompareOptions& options) {
  const CompareSetting setting{engines_of(options), options.assignments,
                               static_cast<int>(options.pictures)};
  check_assignments(setting);
  if (options.pictures < 1 || options.pictures > MaxPictures)
    throw UsageError(
        fmt::format("--pictures {} is out of range; 1..{}", options.pictures, MaxPictures));
  std::unique_ptr<ExpectedFigures> expected;
  if (!options.expect.empty()) expected = std::make_unique<ExpectedFigures>(options.expect);
  const std::vector<CompareGroup> groups = groups_of(options);
  catch_interrupts();
  std::vector<ComparedGroup> compared;
  Progress progress(static_cast<int>(groups.size()));
  for (const CompareGroup& group : groups) {
    progress.draw(static_cast<int>(compared.size()), 0);
    compared.push_back(compare_group(group, setting));
    progress.clear();
    if (interrupted()) return ExitInterrupted;
    if (!options.json) print((compared.size() > 1 ? "\n" : "") + compared_text(compared.back()));
  }
  if (options.json) print(compared_json(compared));
  if (!options.folder.empty()) write_folder(options.folder, compared);
  if (!options.markdown.empty()) write_text(options.markdown, markdown_of(compared));
  if (!options.sheet.empty()) write_picture(options.sheet, compare_sheet(compared));
  if (!expected) return ExitGood;
  const std::vector<std::string> faults = expected->faults(compared);
  for (const std::string& fault : faults) tell(fault);
  return faults.empty() ? ExitGood : ExitDifference;
}

namespace {

void add_options(const CommandOptions& command, CompareOptions& options) {
  const auto file = [&](const char* name, std::string& to, const char* type, const char* help) {
    command.add_option(name, to, help).type_name(type).check(not_empty);
  };
  command
      .add_option("scenes", options.scenes,
                  "demo, or scene files; without any: what each engine was made for, and scenes "
                  "that several draw")
      .type_name("SCENE");
  command.add_option("--engine", options.engines, "Compare this engine; repeatable; all if none")
      .type_name("ENGINE")
      .repeatable();
  command
      .add_option("--set", options.assignments,
                  "Change a knob of an engine, as --set block.cores=1; repeatable")
      .type_name("ENGINE.KNOB=VALUE")
      .repeatable();
  add_number(command, "--pictures", options.pictures, "Draw so many of each scene",
             is_number("--pictures", "1..1000"))
      .capture_default_str();
  file("-o,--output", options.folder, "DIR",
       "Folder for the pictures, how they differ from the golden ones, and compare.json");
  command.add_flag("--json", options.json, "JSON on stdout instead of the tables");
  file("--markdown", options.markdown, "FILE.md", "The tables as Markdown");
  file("--sheet", options.sheet, "FILE.png", "All pictures and hit maps in one");
  file("--expect", options.expect, "FILE",
       "Figures and tolerances; exit code 1 if one is not as expected");
}

}  // namespace

Command compare_row() {
  return make_command<CompareOptions>(
      "compare", "Engines side by side: clocks, memories, multipliers, errors", "Measure",
      "compare common/balls --engine sphere --engine block", add_options, command_compare);
}

}  // namespace racebeam
