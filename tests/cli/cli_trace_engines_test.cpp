// `racebeam trace` with all units of an engine in RTL: the waveform of its models.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/cli/cli_trace_bench.h"

namespace racebeam {
namespace {

using Words = std::vector<std::string>;

struct Window {
  std::string name, scene, from, to;
};

class AllUnitsInRtl : public CliTraceBench, public testing::WithParamInterface<Window> {};

/// A twin may keep other registers, or other values in them while nobody reads them.
bool is_register(const std::string& path) { return path.find("_q") != std::string::npos; }

TEST_P(AllUnitsInRtl, HaveThePortsAndWiresOfTheModelsWithTheSameChanges) {
  const Window& window = GetParam();
  const Words between = {"--from", window.from, "--to", window.to};
  const Wave models = trace(between, "models.vcd", window.scene);
  Words with_rtl = between;
  with_rtl.insert(with_rtl.end(), {"--use", "all=rtl"});
  const Wave rtl = trace(with_rtl, "rtl.vcd", window.scene);
  int moved = 0;
  for (const auto& [path, signal] : models.signals) {
    if (is_register(path)) continue;
    ASSERT_TRUE(rtl.signals.count(path)) << path;
    EXPECT_TRUE(rtl[path] == signal) << path << " changes otherwise";
    moved += signal.changes.size() > 1;
  }
  EXPECT_GT(moved, 50);
}

const std::string Project = RACEBEAM_SOURCE_DIR;
INSTANTIATE_TEST_SUITE_P(
    LongEngines, AllUnitsInRtl,
    testing::Values(Window{"beam", "demo", "7223:100", "7223:101"},
                    Window{"beam_of_a_scene", Project + "/scenes/museum.toml", "40:100", "40:101"},
                    Window{"sphere", Project + "/tests/museum/sphere.toml", "0:40000", "0:43000"},
                    Window{"block", Project + "/tests/museum/block.toml", "0:20000", "0:23000"},
                    Window{"voxel", Project + "/tests/museum/voxel.toml", "0:20000", "0:23000"}),
    [](const auto& window) { return window.param.name; });

}  // namespace
}  // namespace racebeam
