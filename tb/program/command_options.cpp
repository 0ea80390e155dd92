// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/command_options.h"

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "tb/explain/figures.h"
#include "tb/program/number_option.h"

namespace racebeam {

namespace {

constexpr const char* FramesRange = "1..12799 in the demo";
constexpr const char* FirstRange = "0..12798 in the demo";
constexpr long long MostRandomClocks = 1'000'000'000'000;
constexpr long long LargestSeed = 0xffffffff;

template <class Number>
CLI::Option* add_number(CLI::App& command, const char* name, Number& to, const char* help,
                        const CLI::Validator& number) {
  return command.add_option(name, to, help)->type_name("N")->check(number);
}

}  // namespace

const CLI::Validator& not_empty() {
  static const CLI::Validator validator(
      [](const std::string& text) { return text.empty() ? "an empty name" : ""; }, "", "not empty");
  return validator;
}

void add_tt_options(CLI::App& command, TtOptions& options) {
  command
      .add_option("--tt", options.project,
                  "Instead of a scene: verilate the chip of this Tiny Tapeout project (info.yaml) "
                  "and run it")
      ->type_name("DIR")
      ->check(not_empty());
  add_number(command, "--ui", options.ui, "Input pins ui_in of the chip of --tt, 0..255",
             is_number("--ui", "0..255"));
  add_number(command, "--uio", options.uio, "Input pins uio_in of the chip of --tt, 0..255",
             is_number("--uio", "0..255"));
  command
      .add_option("--clock-hz", options.reading.clock_hz,
                  "The clock of the chip of --tt, instead of clock_hz of info.yaml")
      ->type_name("N")
      ->check(is_number("--clock-hz", "in Hz"));
  command.add_option("--define", options.reading.defines, "Define a macro for --tt; repeatable")
      ->type_name("NAME[=VALUE]")
      ->allow_extra_args(false);
  command
      .add_option("-I,--include", options.reading.include_folders,
                  "Look for includes of --tt here, before its own folders; repeatable")
      ->type_name("DIR")
      ->allow_extra_args(false);
  command.add_flag("--trust", options.reading.trust,
                   "Let the RTL of --tt run commands and read and write any file");
  command
      .add_option("--inputs", options.inputs,
                  "Input pins of the chip of --tt that change in time, as `view --record-inputs` "
                  "writes them: frame,line,clock,ui,uio")
      ->type_name("FILE.csv")
      ->check(not_empty());
}

void add_render(CLI::App& app, RenderOptions& options) {
  CLI::App* render = app.add_subcommand("render", "Render frames as files and statistics");
  render
      ->add_option("scene", options.scene,
                   "demo: the chip's own demo, 12799 frames; or a scene file")
      ->type_name("SCENE");
  const auto number = [&](const char* name, long long& to, const char* range, const char* help) {
    add_number(*render, name, to, help, is_number(name, range))->capture_default_str();
  };
  const auto file = [&](const char* name, std::string& to, const char* type, const char* help) {
    render->add_option(name, to, help)->type_name(type)->check(not_empty());
  };
  number("--frames", options.frames, FramesRange, "Frames to render");
  number("--first", options.first, FirstRange, "First frame, 0..12798");
  number("--every", options.every, "1..12798 in the demo", "Render only every Nth frame");
  number("--jobs", options.jobs, "1..256",
         "Processes that share the frames; the files are the same");
  render
      ->add_option("--level", options.level,
                   "tlm: all cores in one loop behind TLM-2.0 sockets (default); signal: units "
                   "wired at 50.4 MHz (default with --use); both give the same")
      ->type_name("LEVEL")
      ->check(not_empty());
  render->add_option("--set", options.assignments, "Set a knob (`racebeam knobs`); repeatable")
      ->type_name("KNOB=VALUE")
      ->allow_extra_args(false);
  render
      ->add_option("--use", options.units,
                   "Put RTL in a unit's place: model, rtl, lockstep (both, compared), or a file; "
                   "UNIT may be all; several with commas; repeatable")
      ->type_name("UNIT=IMPLEMENTATION")
      ->allow_extra_args(false);
  add_tt_options(*render, options);
  file("-o,--output", options.folder, "DIR",
       "Folder for frame_0000.png ..., manifest.json, stats.json; racebeam_out if no file is "
       "asked for");
  render->add_flag("--overwrite", options.overwrite,
                   "Replace the frames of another render that the folder has; without it only "
                   "frames of the same settings are added");
  file("--gif", options.gif, "FILE",
       "Animated GIF at the chip's speed, 60 frames/s; with --every, at most 0.2 s "
       "a frame");
  number("--gif-scale", options.gif_scale, "1..8", "Shrink the GIF N times in both axes, 1..8");
  file("--wav", options.wav, "FILE", "Sound of consecutive frames");
  file("--sheet", options.sheet, "FILE.png", "Contact sheet of up to 120 frames");
  file("--stats", options.stats, "FILE.json", "Statistics");
  file(
      "--vcd", options.vcd, "FILE",
      "Ports and wires of the chip as waveform, FILE.vcd or FILE.fst, with level signal; `racebeam "
      "trace` has windows and registers");
  render
      ->add_option("--golden", options.golden,
                   "trace2, trace4, geometry: render with this golden tracer instead of the chip; "
                   "compare: both, and why they differ")
      ->type_name("TRACER")
      ->check(not_empty());
  render
      ->add_option("--overlay", options.overlays,
                   "slack, cost, depth: also maps of how early each pixel was known, what it cost, "
                   "how many rooms deep it looks: overlay_slack_0000.png ...; several with commas")
      ->type_name("MAP")
      ->allow_extra_args(false);
  file("--against", options.against, "demo|FILE.csv",
       "Compare picture and pins of each frame with checksums: demo, those of the taped-out chip, "
       "or frame,image_crc32,pins_crc32 in a file");
  render->add_flag("--crc", options.crc, "Add CRC-32 of picture and pins to the statistics");
  render->add_flag("--json", options.json, "Statistics as JSON on stdout instead of the table");
}

void add_bench(CLI::App& app, BenchOptions& options) {
  CLI::App* bench = app.add_subcommand("bench", "Measure simulated clocks a second");
  bench->add_option("row", options.rows, "Only these: levels, traces, mixes, host, or units")
      ->type_name("ROW");
  add_number(*bench, "--frames", options.frames, "Frames of each demo part, 1..1000",
             is_number_in("--frames", 1, 1000))
      ->capture_default_str();
  add_number(*bench, "--repeat", options.repeats, "Runs of which the median counts, 1..100",
             is_number_in("--repeat", 1, 100))
      ->capture_default_str();
  bench->add_flag("--json", options.json, "JSON on stdout instead of the table");
}

void add_verify(CLI::App& app, VerifyOptions& options) {
  CLI::App* verify = app.add_subcommand("verify", "Compare model and RTL of units in every clock");
  verify
      ->add_option("unit", options.units,
                   "UNIT; UNIT=FILE.sv, UNIT=A.sv+B.sv, UNIT=LIST.f, UNIT=FOLDER; or all")
      ->type_name("UNIT");
  verify->add_option("--scene", options.scene, "demo, or a scene file")
      ->type_name("SCENE")
      ->capture_default_str();
  add_number(*verify, "--frames", options.frames, "Frames of the chip, spread over the scene",
             is_number("--frames", "0..12799 in the demo"))
      ->capture_default_str();
  add_number(*verify, "--random", options.random, "Clocks of random traffic for each unit",
             is_number_in("--random", 0, MostRandomClocks))
      ->capture_default_str();
  verify->add_option("--set", options.assignments, "Change a knob: see `racebeam knobs`")
      ->type_name("KNOB=VALUE");
  add_number(*verify, "--seed", options.seed, "Of the random traffic",
             is_number_in("--seed", 0, LargestSeed))
      ->capture_default_str();
  verify->add_option("-o,--output", options.folder, "Folder for the waveforms of differences")
      ->type_name("DIR")
      ->check(not_empty())
      ->capture_default_str();
  verify->add_flag("--watch", options.watch, "Again whenever one of the RTL's files is saved");
  verify->add_flag("--json", options.json, "JSON on stdout instead of the table");
}

void add_verilate(CLI::App& app, VerilateOptions& options) {
  CLI::App* verilate = app.add_subcommand(
      "verilate",
      "Make a plug-in of a unit's RTL: for build systems; elsewhere it is made by itself");
  verilate->add_option("unit", options.unit, "Module; its ports are in UNIT.h below sc/")
      ->required()
      ->type_name("UNIT");
  const auto words = [&](const char* name, std::vector<std::string>& to, const char* type,
                         const char* help) {
    return verilate->add_option(name, to, help)->type_name(type)->check(not_empty());
  };
  words("file", options.files, "FILE", ".sv, .v, a list .f, or a folder; none: the unit's own RTL");
  verilate->add_option("-o,--output", options.plugin, "Plug-in, for UNIT=OUT.so")
      ->required()
      ->type_name("OUT.so")
      ->check(not_empty());
  words("-D,--define", options.defines, "NAME[=VALUE]", "Define a macro; repeatable")
      ->allow_extra_args(false);
  words("-G,--parameter", options.parameters, "NAME=VALUE", "Set a parameter; repeatable")
      ->allow_extra_args(false);
  words("-I,--include", options.include_folders, "DIR", "Folder of includes; repeatable")
      ->allow_extra_args(false);
  words("-y,--library", options.libraries, "PATH",
        "File or folder with modules that no file defines; repeatable")
      ->allow_extra_args(false);
  verilate->add_flag("--signals", options.signals,
                     "Registers inside can be read, for waveforms; slower");
  verilate->add_option("--depfile", options.dependencies, "Also write all files read, as for make")
      ->type_name("FILE.d")
      ->check(not_empty());
}

void add_scene(CLI::App& app, SceneOptions& options) {
  CLI::App* scene = app.add_subcommand("scene", "Check, show, draw, start and judge scene files");
  scene->require_subcommand(1);
  const auto add = [&](const char* name, const char* help) {
    CLI::App* command = scene->add_subcommand(name, help);
    command->add_option("file", options.file, "Scene file (TOML)")->required()->type_name("FILE");
    return command;
  };
  add("check", "List all faults with line, column and help");
  add("show", "Counts, widths and an estimate of the worst line")
      ->add_flag("--json", options.json, "JSON on stdout instead of the text");
  add("plan", "Draw rooms, portals and the camera's way")
      ->add_option("-o,--output", options.picture, "Picture: FILE.png or FILE.svg")
      ->required()
      ->type_name("FILE")
      ->check(not_empty());
  add("new", "Write a scene to start from");
  CLI::App* notes = scene->add_subcommand(
      "notes", "Counters of some frames, and why the chip does not show the ideal pictures");
  notes->add_option("scene", options.scenes, "Scene files, or demo")
      ->required()
      ->type_name("SCENE");
  notes->add_option("-o,--output", options.notes, "Markdown")
      ->required()
      ->type_name("FILE.md")
      ->check(not_empty());
  add_number(*notes, "--frames", options.frames, "Frames of each scene, spread evenly over it",
             is_number_in("--frames", 1, 1000))
      ->capture_default_str();
}

void add_view(CLI::App& app, ViewOptions& options) {
  CLI::App* view = app.add_subcommand("view", "Watch a scene in a window, with sound (F1: keys)");
  view->add_option("scene", options.scene, "demo, or a scene file")->type_name("SCENE");
  add_number(*view, "--first", options.first, "First frame", is_number("--first", FirstRange))
      ->capture_default_str();
  add_number(*view, "--frames", options.frames, "End after so many frames, and leave out none",
             is_number("--frames", "1 or more"));
  view->add_option("--level", options.level,
                   "tlm: the cores in one loop; signal: SystemC units wired at 50.4 MHz, at their "
                   "own speed; tlm without --use")
      ->type_name("LEVEL")
      ->check(not_empty());
  view->add_option("--set", options.assignments, "Set a knob (`racebeam knobs`); repeatable")
      ->type_name("KNOB=VALUE")
      ->allow_extra_args(false);
  view->add_option("--use", options.units, "Put RTL in a unit's place, as in render; repeatable")
      ->type_name("UNIT=IMPLEMENTATION")
      ->allow_extra_args(false);
  add_tt_options(*view, options);
  view->add_option("--sound-pin", options.sound_pin,
                   "With --tt: the pin of uio_out that is heard, 0..7; 7")
      ->type_name("N");
  view->add_option("--record-inputs", options.record_inputs,
                   "With --tt: write the inputs, those of the keys too, for --inputs")
      ->type_name("FILE.csv")
      ->check(not_empty());
  view->add_option("-o,--output", options.folder, "Folder for screenshots and GIFs")
      ->type_name("DIR")
      ->check(not_empty())
      ->capture_default_str();
  view->add_option("--keys", options.keys, "Keys to press, one after each picture: \"1 g t o\"")
      ->type_name("NAMES");
  add_number(*view, "--scale", options.scale, "Size of a pixel, 1..8; 0: as large as fits well",
             is_number("--scale", "0..8"))
      ->capture_default_str();
  view->add_flag("--term", options.terminal,
                 "In this terminal, in 24-bit colours, instead of a window; with --frames also as "
                 "text into a file");
  view->add_flag("--paused", options.paused, "Start with the first frame, and wait for keys");
}

void add_explain(CLI::App& app, ExplainOptions& options) {
  CLI::App* explain = app.add_subcommand(
      "explain", "Why a pixel is as it is: its interval, the wall it hits, the clocks it took");
  explain->add_option("scene", options.scene, "demo, or a scene file")->type_name("SCENE");
  add_number(*explain, "--frame", options.frame, "Frame of the scene, from 0",
             is_number("--frame", FirstRange));
  explain
      ->add_option("--pixel", options.pixel,
                   "Pixel of the picture: 0..639,0..479 from the top left")
      ->type_name("X,Y");
  explain->add_option("--set", options.assignments, "Set a knob (`racebeam knobs`); repeatable")
      ->type_name("KNOB=VALUE")
      ->allow_extra_args(false);
  explain->add_flag("--json", options.json, "JSON on stdout instead of the text");
  CLI::Option* const figure =
      explain
          ->add_option("--figure", options.figure,
                       "Draw instead, of pixel 185,100 of frame 700 of the demo unless told "
                       "otherwise: " +
                           figure_names())
          ->type_name("NAME");
  explain->add_option("-o,--output", options.output, "Where to: FILE.svg")
      ->type_name("FILE")
      ->needs(figure);
  explain->add_option("--word", options.word, "Explain a word instead, such as slack")
      ->type_name("WORD")
      ->excludes(figure);
  explain->add_flag("--words", options.words, "Explain all words instead")->excludes(figure);
}

}  // namespace racebeam
