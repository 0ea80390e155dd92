// What a unit's synthesis depends on.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/silicon.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "sc/beam/engine.h"
#include "sc/beam/knob_parameters.h"
#include "sc/beam/knobs.h"
#include "sc/sphere/engine.h"
#include "tb/base/errors.h"
#include "tb/base/project_folder.h"
#include "tb/base/whole_file.h"
#include "tb/sweep/sweep_point.h"
#include "tb/sweep/unit_sources.h"
#include "tb/verilate/rtl_syntax.h"
#include "tests/support/fake_yosys.h"
#include "tests/sweep/sweep_store.h"

namespace racebeam {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;

constexpr const char* Units[] = {"vga_timing", "sequencer",     "camera_unit",       "ray_stepper",
                                 "subdivider", "stacks",        "decision_datapath", "scene",
                                 "navigator",  "interval_fifo", "pixel_output"};

RtlSyntax syntax_of(const std::string& unit) {
  return read_rtl_syntax({unit, {rtl_file(unit)}, {}, {}, {}, {}, RtlSources::Unit, false});
}

std::map<std::string, std::string> hashes(const Silicon& silicon, const knobs& k) {
  std::map<std::string, std::string> hashes;
  for (const UnitParameters& unit : silicon.units_of(k)) hashes[unit.unit] = unit.hash;
  return hashes;
}

/// The units whose hashes differ.
std::set<std::string> differing(const std::map<std::string, std::string>& a,
                                const std::map<std::string, std::string>& b) {
  std::set<std::string> units;
  for (const auto& [unit, hash] : a)
    if (b.at(unit) != hash) units.insert(unit);
  return units;
}

/// A package that none of the sources names: Verilator is given all there are.
bool is_idle_package(const std::string& file, const UnitSources& sources) {
  const std::string name = fs::path(file).stem();
  if (name.size() < 4 || name.substr(name.size() - 4) != "_pkg") return false;
  return std::none_of(sources.files.begin(), sources.files.end(), [&](const std::string& one) {
    return whole_file(one).find(name) != std::string::npos;
  });
}

TEST(UnitSourcesTest, AreWhatVerilatorReads) {
  for (const std::string unit : Units) {
    const RtlSyntax syntax = syntax_of(unit);
    const UnitSources sources = unit_sources(unit, rtl_folders());
    std::set<std::string> files, parameters;
    for (const std::string& file : syntax.files)
      if (!is_idle_package(file, sources)) files.insert(fs::canonical(file));
    for (const auto& parameter : syntax.parameters) parameters.insert(parameter.name);
    std::set<std::string> own;
    for (const std::string& file : sources.files) own.insert(fs::canonical(file));
    EXPECT_EQ(own, files) << unit;
    EXPECT_EQ(sources.parameters, parameters) << unit;
  }
  EXPECT_EQ(unit_sources("pwm_sound", rtl_folders()).files.size(), 4u);
}

TEST(UnitSourcesTest, ParametersAreByDefaultAsKnobsAre) {
  std::map<std::string, std::string> usual;
  for (const rtl_parameter& knob : knob_parameters(knobs()))
    usual[knob.name] = std::to_string(knob.value);
  for (const std::string unit : Units)
    for (const auto& parameter : syntax_of(unit).parameters)
      EXPECT_EQ(parameter.value, usual[parameter.name]) << unit << " " << parameter.name;
}

TEST(UnitSourcesTest, ChangeTheKeyOfWhatIsMadeOfThem) {
  const ScratchFolder folder;
  fs::copy(rtl_folder(), folder.path(), fs::copy_options::recursive);
  const auto keys = [&folder] {
    std::map<std::string, std::string> keys;
    for (const std::string unit : Units)
      keys[unit] = unit_sources(unit, {folder / "base", folder / "beam", folder / "video"}).key;
    return keys;
  };
  const auto whole = keys();
  std::ofstream(folder / "beam/stacks.sv", std::ios::app) << "// more\n";
  EXPECT_EQ(differing(whole, keys()), std::set<std::string>{"stacks"});
  std::ofstream(folder / "base/racebeam_pkg.sv", std::ios::app) << "// more\n";
  EXPECT_EQ(differing(whole, keys()).size(), std::size(Units));
  std::ofstream(folder / "beam/scene_lines.svh") << "`define MORE 1\n";
  const auto before = keys();
  std::ofstream(folder / "beam/scene.sv", std::ios::app) << "`include \"scene_lines.svh\"\n";
  const auto with_more = keys();
  EXPECT_EQ(differing(before, with_more), std::set<std::string>{"scene"});
  std::ofstream(folder / "beam/scene_lines.svh") << "`define MORE 2\n";
  const auto with_another = keys();
  EXPECT_EQ(differing(with_more, with_another), std::set<std::string>{"scene"});
  for (const std::string unit : Units) std::ofstream(folder / ("beam/" + unit + ".sdc"));
  EXPECT_EQ(keys(), with_another);
}

TEST(SiliconTest, AKnobChangesTheUnitsThatHaveItAlone) {
  const Silicon silicon(beam_engine());
  std::map<std::string, std::set<std::string>> units_with;  // by parameter
  for (const std::string unit : Units)
    for (const auto& parameter : syntax_of(unit).parameters)
      units_with[parameter.name].insert(unit);
  const auto chip = hashes(silicon, knobs());
  EXPECT_EQ(chip.size(), std::size(Units)) << "without the sound";
  for (std::size_t i = 0; i < knob_table().size(); ++i) {
    const knob_info& row = knob_table()[i];
    knobs k;
    k.*row.member = k.*row.member == row.max ? row.min : row.max;
    const std::set<std::string> units = units_with[knob_parameters(k)[i].name];
    if (units.empty() && without_pins(k) != knobs())
      EXPECT_THROW(silicon.units_of(k), NoSilicon) << row.name;
    else EXPECT_EQ(differing(chip, hashes(silicon, k)), units) << row.name;
  }
}

TEST(SiliconTest, SphereKnobsChangeTheirUnitsAndTheHostNone) {
  const engine& sphere = sphere_engine();
  const Silicon silicon(sphere);
  const auto with = [&](const char* name, int value) {
    SweepPoint point{"", sphere.standard(nullptr)};
    point.set_knob(*swept_knob(sphere, name), value);
    std::map<std::string, std::string> hashes;
    for (const UnitParameters& unit : silicon.units_of(point.k)) hashes[unit.unit] = unit.hash;
    return hashes;
  };
  const auto chip = with("write_buffer_depth", 64);
  EXPECT_EQ(chip.size(), sphere.unit_names(false).size());
  EXPECT_EQ(differing(chip, with("write_buffer_depth", 8)), std::set<std::string>{"write_buffer"});
  EXPECT_EQ(differing(chip, with("root_bits_per_clock", 2)), std::set<std::string>{"root_unit"});
  for (const char* name : {"host_clocks_per_word", "capture_guard"})
    EXPECT_EQ(with(name, 1), chip) << name;
}

TEST(SiliconTest, AKnobOfTheModelOnlyHasNone) {
  engine other = beam_engine();
  other.parameters = [](const knob_values& k) {
    return std::vector<rtl_parameter>{{"Glow", knobs(k).fifo_merge, "the knob glow"}};
  };
  const Silicon silicon(other);
  EXPECT_EQ(silicon.units_of(knobs()).size(), std::size(Units));
  knobs k;
  k.fifo_merge = 0;
  EXPECT_THROW(silicon.units_of(k), NoSilicon);
  EXPECT_EQ(error_of([&] { silicon.units_of(k); }),
            "the knob glow is of the model only: no unit's RTL has Glow=0");
}

TEST(SiliconTest, SaysWhatTheUnitsAre) {
  knobs k;
  k.interval_stack_depth = 8;
  k.hurry_threshold = -1;
  std::map<std::string, UnitParameters> units;
  for (const UnitParameters& unit : Silicon(beam_engine()).units_of(k)) units[unit.unit] = unit;
  EXPECT_EQ(units["stacks"].parameters, "IntervalStackDepth=8 FaceStackDepth=9 PortalsPerFace=1");
  EXPECT_EQ(units["stacks"].text(), "stacks with IntervalStackDepth=8");
  EXPECT_EQ(units["subdivider"].text(), "subdivider with IntervalStackDepth=8 HurryThreshold=-1");
  EXPECT_EQ(units["scene"].text(), "scene");
}

TEST(SiliconTest, AnotherYosysChangesAllKeys) {
  const auto of_this = hashes(Silicon(beam_engine()), knobs());
  const FakeYosys fake("exit 1");
  const Silicon silicon(beam_engine());
  EXPECT_EQ(silicon.yosys(), FakeYosys::Version);
  EXPECT_EQ(differing(of_this, hashes(silicon, knobs())).size(), std::size(Units));
}

TEST(SiliconTest, YosysThatIsMissingOrDoesNotAnswerIsSaid) {
  const auto error = [] { return error_of([] { Silicon silicon(beam_engine()); }); };
  {
    const FakeYosys fake("exit 1", "echo not yours");
    EXPECT_EQ(error(), "yosys does not say its version: not yours");
  }
  {
    const FakeYosys fake("exit 1", "exit 1");
    EXPECT_THAT(error(), HasSubstr("yosys does not say its version"));
  }
  const ScratchFolder nothing;
  setenv("PATH", nothing.path().c_str(), 1);
  EXPECT_EQ(error(), "yosys is not installed; install the package `yosys`");
  EXPECT_THROW(Silicon silicon(beam_engine()), MissingTool);
}

}  // namespace
}  // namespace racebeam
