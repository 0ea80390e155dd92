// `racebeam trace` on random windows: what its waveforms say is what the cores did, whatever the
// units are made of.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <bitset>
#include <fstream>
#include <sstream>
#include <tuple>

#include "sc/base/unit_choices.h"
#include "sc/beam/units.h"
#include "tb/scene/scene_reader.h"
#include "tb/show/show.h"
#include "tests/cli/cli_trace_bench.h"
#include "tests/cli/traced_window.h"
#include "tests/support/random_knobs.h"

namespace racebeam {
namespace {

using testing::StartsWith;

constexpr int Wires = 110;  // at least; a port drives each, and about one reads it

class CliTraceWindowsTest : public CliTraceBench {
 protected:
  Wave trace_window(const Window& window, const std::string& units, const std::string& file,
                    std::vector<std::string> more = {}, const std::string& scene = "demo") {
    for (const std::string& word : window.arguments()) more.push_back(word);
    if (!units.empty()) more.insert(more.end(), {"--use", units});
    return trace(more, file, scene);
  }
};

/// A window of the demo; every third goes over the end of a frame.
class RandomWindow : public CliTraceWindowsTest, public testing::WithParamInterface<int> {
 protected:
  std::string note() const {
    return "seed " + std::to_string(GetParam()) + ": " + window.from.text() + " to " +
           window.to.text();
  }

  /// The window of a chip with these units, those in lockstep by their instances; its waveform.
  Wave expect_the_chip(const std::string& units, const std::vector<std::string>& beside = {}) {
    const Wave wave = trace_window(window, units, "t.vcd");
    TracedChip chip({}, window.from.frame);
    expect_the_cores(wave, window, chip, beside);
    EXPECT_GT(expect_ports_are_wires(wave), 2 * Wires);
    return wave;
  }

  std::minstd_rand random = random_from(GetParam());
  const Window window = random_window(random, DemoFrames, LineClocks, GetParam() % 3 == 0);
};

TEST_P(RandomWindow, OfModelsHasTheRegistersAndWiresOfTheCoresInEveryClock) {
  SCOPED_TRACE(note());
  expect_the_chip("");
}

TEST_P(RandomWindow, OfRtlHasTheRegistersAndWiresOfTheCoresInEveryClock) {
  SCOPED_TRACE(note());
  expect_the_chip("all=rtl");
}

TEST_P(RandomWindow, OfAMixHasTheRegistersAndWiresOfTheCoresInEveryClock) {
  std::string mix;
  std::vector<std::string> beside;
  for (const std::string& unit : chip_units(false)) {
    const char* const kinds[] = {"model", "rtl", "lockstep"};
    const int kind = below(random, 3);
    mix += (mix.empty() ? "" : ",") + unit + "=" + kinds[kind];
    if (kind == 2) beside.push_back(instance_of(unit));
  }
  SCOPED_TRACE(note() + ", " + mix);
  const Wave wave = expect_the_chip(mix, beside);
  for (const std::string& unit : beside) EXPECT_GT(expect_both_sides(wave, "chip." + unit), 0);
}

/// Lines of a file from the end of its declarations on, but for times.
std::uint64_t changes_in(const std::string& text) {
  std::istringstream in(text.substr(text.find("$enddefinitions")));
  std::uint64_t count = 0;
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) count += line[0] != '#' && line[0] != '$';
  return count;
}

/// `digits` with one bit inverted.
std::string inverted(std::string digits, int bit) {
  char& digit = digits[digits.size() - 1 - static_cast<std::size_t>(bit)];
  digit = digit == '0' ? '1' : '0';
  return digits;
}

/// `text`, a waveform, where the signal has the value `digits` from `time` to its next change.
std::string with_a_value(const std::string& text, const std::string& code,
                         const std::string& digits, std::uint64_t time) {
  const auto at = text.find("\n#" + std::to_string(time) + "\n");
  const auto next = text.find("\n#", at + 1);  // after all changes of that time
  const std::string change = digits.size() == 1 ? digits + code : "b" + digits + " " + code;
  return text.substr(0, next + 1) + change + text.substr(next);
}

/// The digits of a value as it is told: "-3", "306", "0x0a", a bit.
std::string digits_of(const std::string& told, std::size_t bits) {
  const std::uint64_t value =
      told[0] == '-' ? static_cast<std::uint64_t>(std::stoll(told)) : std::stoull(told, nullptr, 0);
  return std::bitset<64>(value).to_string().substr(64 - bits);
}

TEST_P(RandomWindow, OfRtlDiffersInNoSharedSignalUntilABitOfOneIsInverted) {
  SCOPED_TRACE(note());
  const Wave model = trace_window(window, "", "model.vcd");
  const Wave rtl = trace_window(window, "all=rtl", "rtl.vcd");
  Program same(folder.path(), {"trace", "--diff", "model.vcd", "rtl.vcd", "--shared"});
  EXPECT_EQ(same.wait(), 0);
  EXPECT_EQ(same.out(), std::to_string(model.signals.size()) + " shared signals, " +
                            std::to_string(changes_in(read_file(folder / "model.vcd"))) +
                            " changes: no difference\n");

  std::vector<std::string> paths;
  for (const auto& [path, signal] : model.signals)
    if (path.rfind("chip.u_", 0) == 0 && signal.kind == "wire") paths.push_back(path);
  const std::string path = paths[static_cast<std::size_t>(below(random, paths.size()))];
  const std::int64_t first = window.from.ordinal(LineClocks), last = window.to.ordinal(LineClocks);
  const std::int64_t clock = first + below(random, last - first + 1);
  const auto time = static_cast<std::uint64_t>(clock) * Period;
  const std::string was = rtl[path].at(time), is = inverted(was, below(random, rtl[path].bits));
  std::ofstream(folder / "changed.vcd")
      << with_a_value(read_file(folder / "rtl.vcd"), rtl.code(path), is, time);
  const auto names = std::count_if(model.signals.begin(), model.signals.end(), [&](const auto& s) {
    return rtl.code(s.first) == rtl.code(path);
  });
  Program changed(folder.path(), {"trace", "--diff", "model.vcd", "changed.vcd", "--shared"});
  EXPECT_EQ(changed.wait(), 1);
  const FrameClock place = place_at(clock, LineClocks);
  EXPECT_THAT(changed.out(),
              StartsWith("first difference at " + std::to_string(time) + " ps (frame " +
                         std::to_string(place.frame) + ", line " + std::to_string(place.line) +
                         ", clock " + std::to_string(place.clock) + "): " + std::to_string(names) +
                         (names == 1 ? " signal\n" : " signals\n")));
  const std::string row = "\n  " + path + ": ";
  const auto at = changed.out().find(row);
  ASSERT_NE(at, std::string::npos) << changed.out();
  std::istringstream words(changed.out().substr(at + row.size()));
  std::string of_model, of_changed, in, file;
  words >> of_model >> in >> file >> of_changed;
  EXPECT_EQ(digits_of(of_model, was.size()), was);
  EXPECT_EQ(digits_of(of_changed, is.size()), is);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomWindow, testing::Range(1, 4));

/// Settings that are not those of the taped-out chip, for the command line.
std::vector<std::string> assignments(const knobs& k) {
  std::vector<std::string> words;
  for (const knob_info& row : knob_table())
    if (k.*row.member != knobs().*row.member)
      words.insert(words.end(), {"--set", std::string(row.name) + "=" + row.text(k.*row.member)});
  return words;
}

class RandomKnobs : public CliTraceWindowsTest, public testing::WithParamInterface<int> {};

TEST_P(RandomKnobs, HaveTheRegistersAndWiresOfTheCoresInModelsAndRtl) {
  const knobs k = random_knobs(GetParam());
  auto random = random_from(GetParam());
  const Window window =
      random_window(random, DemoFrames, TracedChip(k, 0).line_clocks(), GetParam() % 2 == 0);
  SCOPED_TRACE(window.from.text() + " " + testing::PrintToString(assignments(k)));
  for (const char* units : {"all=model", "all=rtl"}) {
    const Wave wave = trace_window(window, units, "t.vcd", assignments(k));
    TracedChip chip(k, window.from.frame);
    expect_the_cores(wave, window, chip);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomKnobs, testing::Values(1, 2));

/// Scene files: timeline and scene_rom in the places of sequencer and scene.
using SceneCase = std::tuple<std::string, std::string, bool>;  // scene, units, over a frame's end
class SceneWindow : public CliTraceWindowsTest, public testing::WithParamInterface<SceneCase> {};

TEST_P(SceneWindow, HasTheRegistersAndWiresOfTheCoresInEveryClock) {
  const auto& [name, units, over_the_end] = GetParam();
  const std::string file = RACEBEAM_SOURCE_DIR "/scenes/" + name + ".toml";
  const Show show(read_scene_file(file).scene, "");
  auto random = random_from(5);
  const Window window = random_window(random, show.frames(), LineClocks, over_the_end);
  SCOPED_TRACE(window.from.text() + " to " + window.to.text());
  const Wave wave = trace_window(window, units, "t.vcd", {}, file);
  TracedChip chip(show.standard_knobs(), window.from.frame, show.program());
  expect_the_cores(wave, window, chip);
  EXPECT_GT(expect_ports_are_wires(wave), 2 * Wires);
  EXPECT_TRUE(wave.signals.count("chip.u_sequencer.g_turn[2].waited_q"));
}

INSTANTIATE_TEST_SUITE_P(Scenes, SceneWindow,
                         testing::Values(SceneCase{"house", "all=model", false},
                                         SceneCase{"house", "all=rtl", true},
                                         SceneCase{"museum", "all=model", true}),
                         [](const auto& info) {
                           return std::get<0>(info.param) + "_" + std::get<1>(info.param).substr(4);
                         });

// What no reset has reached is 0 or wired, in the cores, models and RTL.
TEST_F(CliTraceWindowsTest, TheFirstAndLastClocksOfTheShowAreThoseOfTheCores) {
  const FrameClock last{DemoFrames - 1, LastLine, LineClocks - 1};
  const Window begin{{0, FirstLine, 0}, {0, FirstLine, 40}};
  const Window end{{last.frame, last.line, last.clock - 40}, last};
  using Case = std::pair<Window, const char*>;
  for (const auto& [window, units] : {Case{begin, "all=model"}, Case{begin, "all=rtl"},
                                      Case{begin, "all=lockstep"}, Case{end, "all=rtl"}}) {
    SCOPED_TRACE(window.from.text() + " " + units);
    TracedChip chip({}, window.from.frame);
    expect_the_cores(trace_window(window, units, "t.vcd"), window, chip);
  }
}

TEST_F(CliTraceWindowsTest, LockstepShowsTheModelsValuesOnTheSideOfTheRtl) {
  auto random = random_from(1);
  const Window window = random_window(random, DemoFrames, LineClocks, false);
  SCOPED_TRACE(window.from.text() + " to " + window.to.text());
  const Wave wave = trace_window(window, "all=lockstep", "t.vcd");
  TracedChip chip({}, window.from.frame);
  std::vector<std::string> units;
  for (const std::string& unit : chip_units(false)) units.push_back(instance_of(unit));
  expect_the_cores(wave, window, chip, units);
  for (const std::string& unit : units)
    EXPECT_GE(expect_both_sides(wave, "chip." + unit), 1) << unit;
  const int whole = expect_both_sides(wave, "chip");  // racebeam_top
  const auto own = std::count_if(wave.signals.begin(), wave.signals.end(), [](const auto& s) {
    return s.first.rfind("chip.", 0) == 0 && s.first.find(".rtl.") == std::string::npos &&
           s.first.find(".clk_i") == std::string::npos;
  });
  EXPECT_EQ(whole, own) << "all of the model's but the clock";
}

}  // namespace
}  // namespace racebeam
