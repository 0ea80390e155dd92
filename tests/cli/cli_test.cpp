// The command line: what is understood, what is refused and how.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "sc/beam/knobs.h"
#include "tb/program/command.h"
#include "tb/program/command_line.h"
#include "tb/program/value_words.h"
#include "tests/cli/program.h"

namespace racebeam {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using Words = std::vector<std::string>;

class CliTest : public testing::Test {
 protected:
  ScratchFolder folder;

  /// Exit code 2, a message with all of `parts`, no result, no file.
  void expect_refused(const Words& words, const std::vector<std::string>& parts) {
    Program program(folder.path(), words);
    EXPECT_EQ(program.wait(), 2) << testing::PrintToString(words);
    EXPECT_EQ(program.out(), "");
    EXPECT_THAT(program.err(), StartsWith("racebeam: "));
    for (const std::string& part : parts) EXPECT_THAT(program.err(), HasSubstr(part));
    EXPECT_EQ(folder.files(), 0);
  }
};

/// The commands of the program, and those that they have, by their words.
std::vector<std::pair<Words, CommandText>> commands() {
  std::vector<std::pair<Words, CommandText>> all;
  for (const CommandText& command : program_text().commands) {
    all.push_back({{command.name}, command});
    for (const CommandText& inner : command.commands)
      all.push_back({{command.name, inner.name}, inner});
  }
  return all;
}

TEST_F(CliTest, HelpNamesEveryCommandAndIsGood) {
  Program program(folder.path(), {"--help"});
  EXPECT_EQ(program.wait(), 0);
  EXPECT_GT(command_table().size(), 9u);
  for (const Command& row : command_table())
    EXPECT_THAT(program.out(), ContainsRegex("\n +" + row.name + " +" + row.summary.substr(0, 9)));
  EXPECT_EQ(program.err(), "");
}

TEST_F(CliTest, HelpOfACommandNamesItsOptionsAndAnExample) {
  for (const auto& [words, command] : commands()) {
    Words all = words;
    all.push_back("--help");
    Program program(folder.path(), all);
    EXPECT_EQ(program.wait(), 0);
    EXPECT_THAT(program.out(), ContainsRegex("Example:\n  racebeam " + words.front() + "[ \n]"));
    for (const OptionText& option : command.options)
      for (const std::string& name : option.names)
        EXPECT_THAT(program.out(), HasSubstr(name)) << words.back();
  }
}

TEST_F(CliTest, ExamplesAreUnderstood) {
  for (const Command& row : command_table())
    EXPECT_NO_THROW(check_command_line(row.example)) << row.example;
}

TEST_F(CliTest, HelpIsAtMost100ColumnsWideAndNamesNoTypesOfAProgram) {
  std::vector<Words> all = {{}};
  for (const auto& [words, command] : commands()) all.push_back(words);
  for (Words words : all) {
    words.push_back("--help");
    Program program(folder.path(), words);
    EXPECT_EQ(program.wait(), 0) << program.err();
    std::istringstream lines(program.out());
    for (std::string line; std::getline(lines, line);) {
      EXPECT_LE(line.size(), 100u) << line;
      for (const char* type : {"TEXT", "INT", "UINT", " in [", "FLOAT"})
        EXPECT_THAT(line, Not(HasSubstr(type)));
    }
  }
}

TEST_F(CliTest, CompletionHasWordsForTypesOfTheHelpOnly) {
  std::set<std::string> types = {"SHELL"};
  for (const auto& [words, command] : commands())
    for (const OptionText& option : command.options) types.insert(option.type);
  for (const std::string& type : types_with_words()) {
    EXPECT_EQ(types.count(type), 1u) << type;
    EXPECT_THAT(value_words(type, "").words, Not(testing::IsEmpty())) << type;
  }
}

TEST_F(CliTest, CompletionGoesOnWhereTheLineEnds) {
  const auto complete = [&](Words words) {
    words.insert(words.begin(), "--complete");
    Program program(folder.path(), words);
    EXPECT_EQ(program.wait(), 0) << program.err();
    return program.out();
  };
  EXPECT_EQ(complete({"rende"}), "render\tRender frames as files and statistics\n");
  EXPECT_EQ(complete({"render", "--ever"}), "--every\tRender only every Nth frame\n");
  EXPECT_EQ(complete({"render", "demo", "--frames", ""}), "") << "a number";
  EXPECT_THAT(complete({"trace", "--diff", "a.vcd", ""}), StartsWith(":files"));
  EXPECT_THAT(complete({"trace", "--diff", "a.vcd", "b.vcd", ""}), HasSubstr("house\t"));
  EXPECT_EQ(complete({"bench", "--json", "level"}), "levels\t\n");
  EXPECT_THAT(complete({"verify", "sta"}), AllOf(HasSubstr("stacks\t\n"), Not(HasSubstr(":"))));
  EXPECT_EQ(complete({"verify", "stacks=m"}), ":files\n");
  EXPECT_EQ(complete({"verify", "-o", ""}), ":folders\n");
  EXPECT_EQ(complete({}), "");
}

TEST_F(CliTest, VersionIsAlone) {
  Program program(folder.path(), {"--version"});
  EXPECT_EQ(program.wait(), 0);
  EXPECT_EQ(program.out(), "racebeam " RACEBEAM_VERSION "\n");
  EXPECT_EQ(program.err(), "") << "not even SystemC's banner";
}

/// Shared libraries that a run of the program opens.
std::vector<std::string> libraries_of(const std::string& folder, const Words& words) {
  Program::Setting setting;
  setting.environment = "LD_DEBUG=files";
  Program program(folder, words, setting);
  EXPECT_EQ(program.wait(), 0);
  const std::string call = "calling init: ";
  std::vector<std::string> libraries;
  std::istringstream lines(program.err());
  for (std::string line; std::getline(lines, line);)
    if (const auto at = line.find(call); at != std::string::npos)
      libraries.push_back(line.substr(at + call.size()));
  return libraries;
}

TEST_F(CliTest, LibrariesOfPicturesAndWindowsAreOpenedByWhatNeedsThem) {
  const auto none_of = [](const char* library) { return Not(Contains(HasSubstr(library))); };
  const auto start = libraries_of(folder.path(), {"--version"});
  EXPECT_THAT(start, Contains(HasSubstr("libsystemc")));
  EXPECT_LT(start.size(), 60u);
  for (const Words& words : {Words{"--version"}, {"render", "demo", "--overlay", "slack"}})
    for (const char* library : {"libracebeam_", "OpenImageIO", "libSDL2"})
      EXPECT_THAT(libraries_of(folder.path(), words), none_of(library));
  EXPECT_THAT(libraries_of(folder.path(), {"render", "demo", "--sheet", "a.png"}),
              AllOf(Contains(HasSubstr("libracebeam_images.so")),
                    Contains(HasSubstr("OpenImageIO")), none_of("libSDL2")));
}

TEST_F(CliTest, ProgramWithoutItsLibrariesSaysWhereItLookedAndWhatToDo) {
  Program::Setting setting;
  setting.program = folder / "racebeam";
  std::filesystem::copy_file(RACEBEAM_BINARY, setting.program);
  const auto refused = [&](const Words& words, const std::string& library) {
    Program program(folder.path(), words, setting);
    EXPECT_EQ(program.wait(), 3);
    EXPECT_THAT(program.err(), HasSubstr(library + " is neither in " + folder.path()));
    return program.err();
  };
  refused({"render", "demo", "--sheet", "a.png"}, "libracebeam_images.so");
  EXPECT_THAT(refused({"view", "demo"}, "libracebeam_window.so"),
              AllOf(HasSubstr("apt install libsdl2-dev"), HasSubstr("racebeam view --term")));
  std::ofstream(folder / "s.toml") << "search = { method = \"nsga2\", population = 8 }\n"
                                      "goals = { picture_error = \"min\", busy = \"min\" }\n"
                                      "knobs.fifo_entries = { from = 3, to = 64 }\n";
  EXPECT_THAT(refused({"sweep", "run", "s.toml", "-o", "out"}, "libracebeam_search.so"),
              AllOf(HasSubstr("apt install libpagmo-dev"), HasSubstr("method = \"sobol\"")));
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  Program doctor(folder.path(), {"doctor"}, setting);
  EXPECT_EQ(doctor.wait(), 3);
  EXPECT_THAT(doctor.out(), AllOf(HasSubstr("OpenImageIO        not found"),
                                  HasSubstr("SDL2               not found"),
                                  HasSubstr("pagmo              not found")));
  EXPECT_THAT(doctor.err(), HasSubstr("caption a picture: libracebeam_images.so is neither in "));
}

TEST_F(CliTest, UnknownNamesAreRefusedWithTheNearest) {
  expect_refused({}, {"command is missing", "--help"});
  expect_refused({"rendr", "demo"}, {"unknown command 'rendr'", "did you mean 'render'?"});
  expect_refused({"--frobnicate"}, {"unknown option '--frobnicate'"});
  expect_refused({"knobs", "--jsn"}, {"unknown option '--jsn'", "'--json'"});
  expect_refused({"render"}, {"scene is required", "racebeam render --help"});
  expect_refused({"render", "dmo"}, {"unknown scene 'dmo'", "'demo'"});
  expect_refused({"render", "demo", "more"}, {"'more' is one argument too many"});
  expect_refused({"render", "demo", "--fraems", "3"}, {"unknown option '--fraems'", "'--frames'"});
  expect_refused({"render", "demo", "--fraems=3"}, {"unknown option '--fraems'", "'--frames'"});
  expect_refused({"render", "demo", "--level", "signl"}, {"unknown level 'signl'", "'signal'"});
  expect_refused({"render", "demo", "--level", "tml"}, {"unknown level 'tml'", "'tlm'"});
  expect_refused({"render", "demo", "--engine", "baem"}, {"unknown engine 'baem'", "'beam'"});
  expect_refused({"knobs", "--engine", "baem"}, {"unknown engine 'baem'", "'beam'"});
}

TEST_F(CliTest, NumbersOutOfRangeAreRefusedWithTheRange) {
  expect_refused({"render", "demo", "--frames", "0"}, {"--frames 0", "1..12799"});
  expect_refused({"render", "demo", "--frames", "12800"}, {"--frames 12800", "1..12799"});
  expect_refused({"render", "demo", "--frames", "many"}, {"--frames", "many"});
  expect_refused({"render", "demo", "--frames"}, {"--frames"});
  expect_refused({"render", "demo", "--first", "12799"}, {"--first 12799", "0..12798"});
  expect_refused({"render", "demo", "--first", "-1"}, {"--first -1", "0..12798"});
  expect_refused({"render", "demo", "--first", "99999999999999999999"}, {"--first", "0..12798"});
  expect_refused({"render", "demo", "--every", "0"}, {"--every 0", "1..12798"});
  expect_refused({"render", "demo", "--gif-scale", "9"}, {"--gif-scale 9", "1..8"});
  expect_refused({"verify", "stacks", "--random", "-5"}, {"--random -5 is out of range; 0..10"});
  expect_refused({"verify", "stacks", "--random", "99999999999999999999"},
                 {"--random 99999999999999999999 is out of range; 0..10"});
  expect_refused({"verify", "stacks", "--seed", "99999999999"},
                 {"--seed 99999999999 is out of range; 0..4294967295"});
  expect_refused({"bench", "--repeat", "0"}, {"--repeat 0 is out of range; 1..100"});
}

TEST_F(CliTest, WhatIsNoNumberIsRefusedWithTheRange) {
  expect_refused({"render", "demo", "--frames", "abc"},
                 {"--frames 'abc' is not a number; 1..12799 in the demo"});
  expect_refused({"verify", "--seed", "x"}, {"--seed 'x' is not a number; 0..4294967295"});
  expect_refused({"verify", "--seed", "1.5"}, {"--seed '1.5' is not a number"});
  expect_refused({"view", "demo", "--scale", "2x"}, {"--scale '2x' is not a number; 0..8"});
  expect_refused({"trace", "demo", "--record", ""}, {"--record '' is not a number"});
  expect_refused({"render", "--tt", ".", "--ui", "0x3"}, {"--ui '0x3' is not a number; 0..255"});
}

TEST_F(CliTest, TheBeginningOfANameIsCompleted) {
  expect_refused({"render", "demo", "--set", "hurry=4"},
                 {"unknown knob 'hurry'; did you mean 'hurry_threshold'?"});
  expect_refused({"render", "demo", "--set", "stack=4"}, {"did you mean 'face_stack_depth'?"});
  expect_refused({"render", "demo", "--fram", "4"}, {"did you mean '--frames'?"});
}

TEST_F(CliTest, CommandsForFilesNameTheFileOfTheDemo) {
  for (const char* command : {"check", "show"})
    expect_refused({"scene", command, "demo"}, {"demo is built into the chip", "scenes/demo.toml"});
  expect_refused({"scene", "plan", "demo", "-o", "a.png"}, {"scenes/demo.toml"});
  expect_refused({"scene", "show", "dmo"}, {"unknown scene 'dmo'; did you mean 'demo'?"});
}

TEST_F(CliTest, KnobsOutOfRangeAreRefusedWithTheRange) {
  const auto set = [](const char* assignment) {
    return Words{"render", "demo", "--set", assignment};
  };
  expect_refused(set("fifo_entris=4"), {"unknown knob 'fifo_entris'", "'fifo_entries'"});
  expect_refused(set("fifo_entries=65"), {"fifo_entries", "'65'", "3..64 entries"});
  expect_refused(set("fifo_entries=2"), {"'2'", "3..64"});
  expect_refused(set("fifo_entries=4x"), {"'4x'", "3..64"});
  expect_refused(set("fifo_entries="), {"''", "3..64"});
  expect_refused(set("bisection=middle"), {"'middle'", "pow2, midpoint"});
  expect_refused(set("interlace"), {"'interlace'", "knob=value"});
}

TEST_F(CliTest, KnobsOfTheSceneFileAreRefusedAsSuch) {
  for (const knob_info& row : knob_table())
    if (row.of_scene)
      expect_refused({"render", "demo", "--set", std::string(row.name) + "=1"},
                     {row.name, "the scene file sets it"});
  expect_refused({"render", "demo", "--set", "navigator_bit=9"}, {"unknown knob 'navigator_bit'"});
}

TEST_F(CliTest, SoundNeedsConsecutiveFramesAtTheChipsClock) {
  expect_refused({"render", "demo", "--wav", "a.wav", "--every", "2"}, {"--wav", "--every"});
  expect_refused({"render", "demo", "--wav", "a.wav", "--set", "clocks_per_pixel=4"},
                 {"--wav", "clocks_per_pixel=2"});
}

TEST_F(CliTest, OutputsThatCannotBeAreRefusedBeforeSimulating) {
  expect_refused({"render", "demo", "--sheet", "a.png", "--frames", "121"}, {"--sheet", "120"});
  expect_refused({"render", "demo", "--gif", "a", "--wav", "./a"}, {"a", "two outputs"});
  expect_refused({"render", "demo", "--gif", ""}, {"--gif", "empty"});
  expect_refused({"render", "demo", "-o", ""}, {"--output", "empty"});
  expect_refused({"render", "demo", "--gif", "no/a.gif"}, {"no/a.gif", "No such file"});
  expect_refused({"render", "demo", "-o", "new", "--wav", "no/a.wav"}, {"no/a.wav"});
  expect_refused({"render", "demo", "--stats", "."}, {"cannot write .", "directory"});
  expect_refused({"render", "demo", "-o", "/proc/racebeam"}, {"cannot write /proc/racebeam"});
  expect_refused({"render", "demo", "-o", RACEBEAM_BINARY "/out"}, {"Not a directory"});
}

TEST_F(CliTest, DoctorIsGoodHere) {
  Program text(folder.path(), {"doctor"});
  EXPECT_EQ(text.wait(), 0) << text.out() << text.err();
  EXPECT_THAT(text.out(), HasSubstr("SystemC            2.3"));
  EXPECT_THAT(text.out(), Not(HasSubstr("FAILED")));
  Program program(folder.path(), {"doctor", "--json"});
  const auto json = program.json();
  EXPECT_EQ(json.at("versions").at("racebeam"), RACEBEAM_VERSION);
  EXPECT_EQ(json.at("checks").size(), 7);
  EXPECT_EQ(json.at("tools").size(), 6);
}

TEST_F(CliTest, DoctorEndsWith3WhenSomethingRequiredIsMissing) {
  Program program(folder.path(), {"doctor"}, {{}, RLIM_INFINITY, false, "TMPDIR=/no/such/folder"});
  EXPECT_EQ(program.wait(), 3);
  EXPECT_THAT(program.out(), HasSubstr("FAILED"));
  EXPECT_THAT(program.err(), HasSubstr("temporary folder"));
}

TEST_F(CliTest, DoctorNamesThePackageOfAMissingTool) {
  Program program(folder.path(), {"doctor"}, {{}, RLIM_INFINITY, false, "PATH=/no/such/folder"});
  EXPECT_EQ(program.wait(), 0) << "optional tools may be missing";
  EXPECT_THAT(program.out(), HasSubstr("apt install gtkwave"));
}

// As a command that SIGPIPE ends; what was written is whole.
TEST_F(CliTest, AReaderThatHasGoneEndsEveryCommandQuietly) {
  std::ofstream(folder / "a.toml") << "frames = 9\nplan.storeys = \"@.\"\n";
  for (const Words& words : {Words{"knobs", "--json"},
                             {"--help"},
                             {"render", "demo", "-o", "o", "--frames", "2"},
                             {"render", "demo", "-o", "p", "--golden", "trace2"},
                             {"scene", "show", "a.toml"},
                             {"explain", "demo", "--frame", "0", "--pixel", "9,9"}}) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    close(ends[0]);  // nobody reads
    Program program(folder.path(), words,
                    {"/proc/self/fd/" + std::to_string(ends[1]), RLIM_INFINITY, false, {}});
    EXPECT_EQ(program.wait(), 141) << words[0];
    EXPECT_EQ(program.err(), "") << words[0];
    close(ends[1]);
  }
}

TEST_F(CliTest, FullStandardOutputIsAnError) {
  Program program(folder.path(), {"knobs"}, {"/dev/full", RLIM_INFINITY, false, {}});
  EXPECT_EQ(program.wait(), 2);
  EXPECT_THAT(program.err(), HasSubstr("cannot write the standard output: No space left"));
}

}  // namespace
}  // namespace racebeam
