// The registers of tlm_chip over its socket: contents, times and responses.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "tb/bench/core_bench.h"
#include "tests/beam/tlm_platform.h"

namespace racebeam {
namespace {

using TlmRegisters = TlmPlatform;

TEST_F(TlmRegisters, ShowsItsStateInRegisters) {
  EXPECT_EQ(host.read(RegisterId), RegisterIdValue);
  EXPECT_EQ(host.read(RegisterFrames), 0u);
  EXPECT_EQ(host.read(RegisterClocks), 0u);
  run_frames(3);
  EXPECT_EQ(host.read(RegisterFrame), 3u);
  EXPECT_EQ(static_cast<int>(host.read(RegisterLine)), FirstLine);
  EXPECT_EQ(host.read(RegisterFrames), 3u);
  EXPECT_EQ(host.read_64(RegisterClocks), 3u * 840000);
  EXPECT_EQ(host.read(RegisterLineClocks), 1600u);
  EXPECT_EQ(host.read(RegisterPeriod), 19841u);
}

TEST_F(TlmRegisters, ShowsItsKnobsInTheOrderOfTheTable) {
  const knobs defaults;
  for (std::size_t i = 0; i < knob_table().size(); ++i)
    EXPECT_EQ(static_cast<int>(host.read(RegisterKnobs + 4 * i)), defaults.*knob_table()[i].member)
        << knob_table()[i].name;
  EXPECT_EQ(host.access(tlm::TLM_READ_COMMAND, RegisterKnobs + 4 * knob_table().size(), &word, 4),
            tlm::TLM_ADDRESS_ERROR_RESPONSE);
}

TEST_F(TlmRegisters, ShowsTheStatisticsOfTheLastWholeFrame) {
  tlm::tlm_global_quantum::instance().set(LineTime);  // or it may be a frame ahead
  EXPECT_EQ(host.read_64(RegisterCounters), 0u);
  chip.deposit(7223);
  run_frames(1);
  sc_core::sc_start(100 * LineTime);  // into the next
  const frame_stats want = CoreBench({}, 7223).render().stats;
  const auto registers = counter_registers();
  for (std::size_t i = 0; i < registers.size(); ++i)
    EXPECT_EQ(host.read_64(RegisterCounters + 8 * i), want.*registers[i]) << "register " << i;
  for (std::size_t i = 0; i < want.fifo_fill.size(); ++i) {
    EXPECT_EQ(host.read_64(RegisterFifoFill + 8 * i), want.fifo_fill[i]);
    EXPECT_EQ(host.read_64(RegisterStackDepth + 8 * i), want.stack_depth[i]);
    EXPECT_EQ(host.read_64(RegisterWalkSteps + 8 * i), want.walk_steps[i]);
    EXPECT_EQ(host.read_64(RegisterSlack + 8 * i), want.slack[i]);
  }
  std::vector<int> rows(VisibleRows);
  const auto read_rows = [&](std::uint64_t address) {
    EXPECT_EQ(host.access(tlm::TLM_READ_COMMAND, address, rows.data(), 4 * VisibleRows),
              tlm::TLM_OK_RESPONSE);
    return rows;
  };
  EXPECT_EQ(read_rows(RegisterCameraClocks), want.camera_clocks);
  EXPECT_EQ(read_rows(RegisterFirstEmit), want.first_emit);
  EXPECT_EQ(read_rows(RegisterDoneClock), want.done_clock);
  EXPECT_EQ(read_rows(RegisterBusyClocks), want.busy_clocks);
  EXPECT_EQ(read_rows(RegisterStackNeeded), want.stack_needed);
  EXPECT_EQ(read_rows(RegisterLineParts + PartCamera * LinesPitch), want.line_camera);
  EXPECT_EQ(read_rows(RegisterLineParts + PartIdle * LinesPitch), want.line_idle);
}

TEST_F(TlmRegisters, ResetRegisterStartsTheDemoAnewBeforeTheNextLine) {
  chip.deposit(5000);
  run_frames(1);
  word = 1;
  EXPECT_EQ(host.access(tlm::TLM_WRITE_COMMAND, RegisterReset, &word, 4), tlm::TLM_OK_RESPONSE);
  EXPECT_EQ(host.read(RegisterFrame), 5001u);
  sc_core::sc_start(FrameTime + Clock);
  EXPECT_EQ(host.read(RegisterFrame), 1u);
  EXPECT_EQ(host.read_64(RegisterClocks), 2u * 840000 + 1);
  const auto want = CoreBench({}, 0).render();
  EXPECT_TRUE(std::equal(want.colours.begin(), want.colours.end(), display.bytes.begin()));
}

TEST_F(TlmRegisters, WritingZeroToTheResetRegisterDoesNothing) {
  run_frames(1);
  EXPECT_EQ(host.access(tlm::TLM_WRITE_COMMAND, RegisterReset, &word, 4), tlm::TLM_OK_RESPONSE);
  run_frames(1);
  EXPECT_EQ(host.read(RegisterFrame), 2u);
}

TEST_F(TlmRegisters, AWordTakesAClock) {
  std::uint32_t words[3];
  EXPECT_EQ(host.access(tlm::TLM_READ_COMMAND, RegisterFrame, words, sizeof words),
            tlm::TLM_OK_RESPONSE);
  EXPECT_EQ(host.delay, 3 * Clock);
  EXPECT_FALSE(host.payload.is_dmi_allowed());
}

TEST_F(TlmRegisters, RefusesWhatIsNoRegister) {
  for (const std::uint64_t address :
       {std::uint64_t{0x02}, std::uint64_t{0x24}, std::uint64_t{0x3fc}, std::uint64_t{0x1780},
        std::uint64_t{0x3000}, std::uint64_t{1} << 40})
    for (const auto command : {tlm::TLM_READ_COMMAND, tlm::TLM_WRITE_COMMAND})
      EXPECT_EQ(host.access(command, address, &word, 4), tlm::TLM_ADDRESS_ERROR_RESPONSE)
          << address;
  EXPECT_EQ(host.delay, sc_core::SC_ZERO_TIME);
}

TEST_F(TlmRegisters, RefusesToWriteWhatIsReadOnlyAndToReadWhatIsWriteOnly) {
  for (const std::uint64_t address : {std::uint64_t{RegisterFrame}, std::uint64_t{RegisterKnobs},
                                      std::uint64_t{RegisterCounters}})
    EXPECT_EQ(host.access(tlm::TLM_WRITE_COMMAND, address, &word, 4),
              tlm::TLM_COMMAND_ERROR_RESPONSE);
  EXPECT_EQ(host.access(tlm::TLM_READ_COMMAND, RegisterReset, &word, 4),
            tlm::TLM_COMMAND_ERROR_RESPONSE);
}

TEST_F(TlmRegisters, RefusesPartsOfWordsStreamingAndByteEnables) {
  std::uint32_t words[2];
  EXPECT_EQ(host.access(tlm::TLM_READ_COMMAND, RegisterFrame, words, 3),
            tlm::TLM_BURST_ERROR_RESPONSE);
  host.prepare(tlm::TLM_READ_COMMAND, RegisterFrame, words, 8);
  host.payload.set_streaming_width(4);
  host.socket->b_transport(host.payload, host.delay);
  EXPECT_EQ(host.payload.get_response_status(), tlm::TLM_BURST_ERROR_RESPONSE);
  host.prepare(tlm::TLM_READ_COMMAND, RegisterFrame, words, 4);
  unsigned char enables[4] = {0xff, 0xff, 0xff, 0xff};
  host.payload.set_byte_enable_ptr(enables);
  host.payload.set_byte_enable_length(4);
  host.socket->b_transport(host.payload, host.delay);
  EXPECT_EQ(host.payload.get_response_status(), tlm::TLM_BYTE_ENABLE_ERROR_RESPONSE);
}

TEST_F(TlmRegisters, IgnoresTheIgnoreCommand) {
  word = 77;
  EXPECT_EQ(host.access(tlm::TLM_IGNORE_COMMAND, RegisterFrame, &word, 4), tlm::TLM_OK_RESPONSE);
  EXPECT_EQ(word, 77u);
}

TEST_F(TlmRegisters, DebugReadsAsManyWordsAsThereAreAndWritesNone) {
  std::vector<std::uint32_t> words(100, 5);
  host.prepare(tlm::TLM_READ_COMMAND, RegisterKnobs, words.data(), 400);
  EXPECT_EQ(host.socket->transport_dbg(host.payload), 4 * knob_table().size());
  EXPECT_EQ(words[0], 4u);
  EXPECT_EQ(words[knob_table().size()], 5u);
  word = 1;
  host.prepare(tlm::TLM_WRITE_COMMAND, RegisterReset, &word, 4);
  EXPECT_EQ(host.socket->transport_dbg(host.payload), 0u);
  run_frames(2);
  EXPECT_EQ(host.read(RegisterFrame), 2u);
}

TEST_F(TlmRegisters, GivesNoDirectMemory) {
  tlm::tlm_dmi memory;
  host.prepare(tlm::TLM_READ_COMMAND, RegisterFrame, &word, 4);
  EXPECT_FALSE(host.socket->get_direct_mem_ptr(host.payload, memory));
  EXPECT_TRUE(memory.is_none_allowed());
  EXPECT_EQ(memory.get_start_address(), 0u);
  EXPECT_EQ(memory.get_end_address(), ~std::uint64_t{0});
}

// No table runs into the next.
TEST(CounterTable, TablesFitBetweenTheirAddresses) {
  EXPECT_LE(RegisterCounters + 8 * counter_registers().size(), std::uint64_t{RegisterFifoFill});
  EXPECT_LE(RegisterKnobs + 4 * knob_table().size(), std::uint64_t{RegisterCounters});
  std::set<std::string> names;
  for (const counter_row& row : counter_table()) names.insert(row.info.name);
  EXPECT_EQ(names.size(), counter_table().size());
}

}  // namespace
}  // namespace racebeam
