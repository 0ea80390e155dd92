// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/command_explain.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <utility>

#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/base/output_file.h"
#include "tb/explain/explainers.h"
#include "tb/explain/figures.h"
#include "tb/explain/glossary.h"
#include "tb/program/common_options.h"
#include "tb/show/open_show.h"

namespace racebeam {

namespace {

struct Pixel {
  int column, row;
};

std::optional<int> whole_number(const std::string& text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

Pixel pixel_of(const std::string& text) {
  const auto comma = text.find(',');
  std::optional<int> column, row;
  if (comma != std::string::npos) {
    column = whole_number(text.substr(0, comma));
    row = whole_number(text.substr(comma + 1));
  }
  if (!column || !row)
    throw UsageError(
        fmt::format("--pixel '{}' is not of the form X,Y, as in --pixel 320,240", text));
  return {*column, *row};
}

void expect_inside(const Pixel& pixel, const Explainer::Size& size) {
  if (pixel.column < 0 || pixel.column >= size.columns || pixel.row < 0 || pixel.row >= size.rows)
    throw UsageError(fmt::format("--pixel {},{} is outside the picture; X is 0..{}, Y is 0..{}",
                                 pixel.column, pixel.row, size.columns - 1, size.rows - 1));
}

/// What is asked about.
struct Subject : Run {
  int frame;
  Pixel pixel;
  const Explainer& explainer;
};

Subject subject_of(const ExplainOptions& options) {
  const Pixel pixel = pixel_of(options.pixel);
  Run run = open_run(options);
  const Explainer* const explainer = explainer_of(run.show.engine());
  if (!explainer)
    throw UsageError(fmt::format("there is no explain for {} yet", run.show.engine().name));
  const int last = run.show.frames() - 1;
  if (options.frame < 0 || options.frame > last)
    throw UsageError(fmt::format("--frame {} is out of range; 0..{}", options.frame, last));
  expect_inside(pixel, explainer->size(run, static_cast<int>(options.frame)));
  return {std::move(run), static_cast<int>(options.frame), pixel, *explainer};
}

int explain_pixel(const ExplainOptions& options) {
  const char* const missing = options.scene.empty()              ? "a scene"
                              : options.frame == options.NoFrame ? "--frame"
                              : options.pixel.empty()            ? "--pixel"
                                                                 : nullptr;
  if (missing)
    throw UsageError(
        fmt::format("{} is required, as in `racebeam explain demo --frame 1000 --pixel 320,240`; "
                    "or --figure, --word; see `racebeam explain --help`",
                    missing));
  const Subject s = subject_of(options);
  const std::string repeat = options.scene + options.set_text();
  const auto explain = options.json ? s.explainer.json : s.explainer.text;
  print(explain(s, {s.frame, s.pixel.column, s.pixel.row}, repeat));
  return ExitGood;
}

int draw_figure(ExplainOptions options) {
  const Figure& wanted = figure(options.figure);
  if (options.output.empty()) throw UsageError("--figure needs -o FILE.svg");
  if (extension_of(options.output) != ".svg")
    throw UsageError("--figure writes .svg; rename " + options.output);
  if (options.scene.empty()) options.scene = "demo";
  if (options.frame == options.NoFrame) options.frame = 700;
  if (options.pixel.empty()) options.pixel = "185,100";
  const Subject s = subject_of(options);
  expect_rooms(s.show, "--figure");
  if (s.pixel.column == 0)
    throw UsageError("no ray is shown in column 0, which is the FIFO's; X is 1..639 for a figure");
  write_text(options.output, wanted.draw({s.show, s.k, s.frame, s.pixel.row + FirstVisibleLine,
                                          s.pixel.column - 1}));
  tell(fmt::format("wrote {}: {}", options.output, wanted.meaning));
  return ExitGood;
}

}  // namespace

int command_explain(const ExplainOptions& options) {
  if (options.words) {
    print(words_text(glossary()));
  } else if (!options.word.empty()) {
    print(words_text({glossary_word(options.word)}));
  } else {
    return options.figure.empty() ? explain_pixel(options) : draw_figure(options);
  }
  return ExitGood;
}

namespace {

void add_options(const CommandOptions& command, ExplainOptions& options) {
  command.add_option("scene", options.scene, "demo, or a scene file").type_name("SCENE");
  add_number(command, "--frame", options.frame, "Frame or picture of the scene, from 0",
             is_number("--frame", FirstRange));
  command
      .add_option("--pixel", options.pixel,
                  "Pixel of the picture, from the top left: up to 639,479")
      .type_name("X,Y");
  add_run_options(command, options);
  command.add_flag("--json", options.json, "JSON on stdout instead of the text");
  const CommandOption figure =
      command
          .add_option("--figure", options.figure,
                      "Draw instead, of pixel 185,100 of frame 700 of the demo unless told "
                      "otherwise: " +
                          figure_names())
          .type_name("NAME");
  command.add_option("-o,--output", options.output, "Where to: FILE.svg")
      .type_name("FILE")
      .needs(figure);
  command.add_option("--word", options.word, "Explain a word instead, such as slack")
      .type_name("WORD")
      .excludes(figure);
  command.add_flag("--words", options.words, "Explain all words instead").excludes(figure);
}

}  // namespace

Command explain_row() {
  return make_command<ExplainOptions>(
      "explain", "Why a pixel is as it is: its interval, the wall it hits, the clocks it took",
      "See", "explain demo --frame 1000 --pixel 320,240", add_options, command_explain);
}

}  // namespace racebeam
