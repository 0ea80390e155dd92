// A chip that makes no progress ends, and says who waits for whom: one deadlock or livelock is
// planted in the RTL of a unit at a time, and the last of the chain is that unit.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "tests/cli/hang_plants.h"
#include "tests/cli/program.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using testing::Not;
using Words = std::vector<std::string>;

/// For the voxel tracer: in its middle a ray that is level, and above everything.
constexpr const char* Level = R"(
name = "level"
engine = "voxel"
[terrain]
function = "tiny"
size = [64, 64, 32]
[camera]
position = [32.5, 2.25, 31.5]
d00 = [-6710880, 10066330, 5033160]
dx = [209715, 0, 0]
dy = [0, 0, -209715]
[picture]
size = [64, 48]
)";

class PlantTest : public testing::TestWithParam<Plant> {
 protected:
  /// With the RTL of the unit's folder, in which one text is another.
  Program run() {
    const Plant& p = GetParam();
    namespace fs = std::filesystem;
    const fs::path own = fs::path(RACEBEAM_SOURCE_DIR "/rtl") / p.file;
    const std::string mine = folder.path() + "/mine/";
    fs::copy(own.parent_path(), mine);
    std::string text = read_file(own.string());
    const auto at = text.find(p.right);
    EXPECT_NE(at, std::string::npos) << p.right;
    if (at != std::string::npos) text.replace(at, std::string(p.right).size(), p.wrong);
    std::ofstream(mine + own.filename().string()) << text;
    std::ofstream(folder / "level.toml") << Level;
    return Program(folder.path(), words());
  }

  Words words() const {
    const Plant& p = GetParam();
    Words more(p.more.begin(), p.more.end());
    std::string scene = "demo";
    if (p.engine != std::string("beam"))
      scene = std::string(RACEBEAM_SOURCE_DIR "/tests/museum/") + p.engine + ".toml";
    if (!more.empty() && more.front().rfind("--", 0) != 0) {
      scene = more.front();
      more.erase(more.begin());
    }
    Words all = {"render", scene, "--use", std::string(p.unit) + "=mine/" + p.unit + ".sv",
                 "--crc"};
    if (scene == "demo") all.insert(all.end(), {"--first", "7223", "--frames", "2"});
    else all.insert(all.end(), {"--frames", "1"});
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  void expect_named() {
    Program program = run();
    EXPECT_EQ(program.wait(), 2) << program.err();
    const std::string said = program.err();
    EXPECT_THAT(said, HasSubstr("the chip makes no progress: "));
    EXPECT_THAT(said, HasSubstr(std::string(GetParam().unit) + " waits for nobody"));
    EXPECT_THAT(said, Not(HasSubstr("internal error")));
  }

  ScratchFolder folder;
};

using CliHangTest = PlantTest;
TEST_P(CliHangTest, IsNamedAtTheEndOfTheChain) { expect_named(); }
using LongCliHangTest = PlantTest;
TEST_P(LongCliHangTest, IsNamedAtTheEndOfTheChain) { expect_named(); }

using LongHarmlessTest = PlantTest;
TEST_P(LongHarmlessTest, StopsNothing) {
  Program program = run();
  EXPECT_EQ(program.wait(), 0) << program.err();
}

const auto name_of = [](const testing::TestParamInfo<Plant>& plant) {
  return std::string(plant.param.name) + "_" + plant.param.engine;
};
INSTANTIATE_TEST_SUITE_P(Plants, CliHangTest, testing::ValuesIn(quick_plants()), name_of);
INSTANTIATE_TEST_SUITE_P(LongPlants, LongCliHangTest, testing::ValuesIn(other_plants()), name_of);
INSTANTIATE_TEST_SUITE_P(LongPlants, LongHarmlessTest, testing::ValuesIn(harmless_plants()),
                         name_of);

/// For the voxel tracer: a world whose columns the host sends for more than two frames.
constexpr const char* Large = R"(
name = "large"
engine = "voxel"
[terrain]
function = "hills"
size = [1024, 2048, 64]
voxel = [16, 16, 16]
[camera]
position = [256, 0, 80]
[picture]
size = [64, 48]
)";

// RTL that is right, which may starve, restart and wait as it likes.
void expect_no_alarm(const Words& more, const char* scene = "demo",
                     const char* unit = "interval_fifo") {
  const ScratchFolder folder;
  std::ofstream(folder / "large.toml") << Large;
  Words words = {"render", scene,    "--use", std::string(unit) + "=rtl",
                 "--crc",  "--json", "-o",    "out"};
  words.insert(words.end(), more.begin(), more.end());
  Program run(folder.path(), words);
  EXPECT_EQ(run.wait(), 0) << run.err();
}
TEST(NoAlarm, InTheFramesThatStarveMostAndWithTheLockEffect) {
  expect_no_alarm({"--at", "2600,4860,7140"});
}
TEST(NoAlarm, InAChipThatHardlyEverEndsALine) {
  expect_no_alarm(
      {"--at", "7140", "--set", "clocks_per_pixel=1", "--set", "interval_stack_depth=1"});
}
TEST(NoAlarm, WithStallsMostOfTheTime) {
  expect_no_alarm({"--at", "7140", "--shake", "1,0.3,0.99"});
}
TEST(LongNoAlarm, WhileTheHostSendsALargeWorld) {
  expect_no_alarm({"--frames", "1"}, "large.toml", "voxel_shade");
}
TEST(LongNoAlarm, In128FramesOfTheDemo) { expect_no_alarm({"--frames", "128", "--every", "99"}); }

}  // namespace
}  // namespace racebeam
