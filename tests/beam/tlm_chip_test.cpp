// tlm_chip in someone's virtual platform: what its display gets, and when.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/core_bench.h"
#include "tests/beam/tlm_platform.h"

namespace racebeam {
namespace {

using TlmChip = TlmPlatform;

TEST_F(TlmChip, FillsAMemoryWithThePicture) {
  chip.deposit(5000);
  run_frames(1);
  const auto want = CoreBench({}, 5000).render();
  const std::vector<std::uint8_t> got(display.bytes.begin(),
                                      display.bytes.begin() + want.colours.size());
  EXPECT_TRUE(got == want.colours);
  EXPECT_EQ(display.bytes[DisplayFrame] | display.bytes[DisplayFrame + 1] << 8, 5000);
  EXPECT_EQ(display.writes, VisibleRows + 1);
}

// Row r ends with its line, 34 + r lines after the start; the frame with its last line.
TEST_F(TlmChip, AnnotatesEachLineWithTheTimeOfItsEnd) {
  run_frames(1);
  std::set<sc_core::sc_time> ends{Clock + FrameTime};
  for (int row = 0; row < VisibleRows; ++row) ends.insert(Clock + (34 + row) * LineTime);
  EXPECT_TRUE(display.times == ends);
}

TEST_F(TlmChip, SendsTheSamePicturesAtTheSameTimesWithAnyQuantum) {
  tlm::tlm_global_quantum::instance().set(3.5 * LineTime);
  chip.deposit(700);
  run_frames(2);
  const auto want = CoreBench({}, 701).render();
  EXPECT_TRUE(std::equal(want.colours.begin(), want.colours.end(), display.bytes.begin()));
  EXPECT_EQ(*display.times.rbegin(), Clock + 2 * FrameTime);
  EXPECT_EQ(display.times.size(), 2u * (VisibleRows + 1));
}

// In the middle of a frame no more lines are known than the quantum allows.
TEST_F(TlmChip, RunsAheadByTheQuantumAtMost) {
  tlm::tlm_global_quantum::instance().set(10 * LineTime);
  run_frames(1);
  sc_core::sc_start(100 * LineTime);
  const int line = static_cast<int>(host.read(RegisterLine)) - FirstLine;
  EXPECT_GE(line, 100);
  EXPECT_LE(line, 111);
}

TEST(TlmChipAlone, ReportsADisplayThatRefusesALine) {
  tlm_chip chip{"chip", {}};
  Memory display{"display", 1000};
  chip.display_socket.bind(display.socket);
  try {
    sc_core::sc_start(FrameTime);
    FAIL() << "nothing was reported";
  } catch (const sc_core::sc_report& report) {
    EXPECT_EQ(report.get_severity(), sc_core::SC_ERROR);
    EXPECT_NE(std::string(report.what()).find("TLM_ADDRESS_ERROR_RESPONSE"), std::string::npos)
        << report.what();
  }
  EXPECT_EQ(display.writes, 1);
}

}  // namespace
}  // namespace racebeam
