// tlm_chip in someone's virtual platform: a memory as display, a host that reads registers.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/tlm_chip.h"

#include <gtest/gtest.h>

#include <set>

#include "tb/core_bench.h"

namespace racebeam {
namespace {

using tlm::tlm_response_status;

/// A target of so many bytes; counts what is written, and when.
class Memory : public sc_core::sc_module {
 public:
  tlm_utils::simple_target_socket<Memory> socket{"socket"};
  std::vector<std::uint8_t> bytes;
  std::set<sc_core::sc_time> times;  // of all writes
  int writes = 0;

  Memory(const sc_core::sc_module_name& name, std::size_t size) : sc_module(name), bytes(size) {
    socket.register_b_transport(this, &Memory::access);
  }

 private:
  void access(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
    const std::uint64_t begin = payload.get_address(), end = begin + payload.get_data_length();
    payload.set_response_status(end > bytes.size() ? tlm::TLM_ADDRESS_ERROR_RESPONSE
                                                   : tlm::TLM_OK_RESPONSE);
    if (end > bytes.size()) return;
    ++writes;
    times.insert(sc_core::sc_time_stamp() + delay);
    std::copy_n(payload.get_data_ptr(), end - begin,
                bytes.begin() + static_cast<std::ptrdiff_t>(begin));
  }
};

/// A processor that asks when the test tells it to.
class Host : public sc_core::sc_module {
 public:
  tlm_utils::simple_initiator_socket<Host> socket{"socket"};
  tlm::tlm_generic_payload payload;
  sc_core::sc_time delay;

  explicit Host(const sc_core::sc_module_name& name) : sc_module(name) {}

  tlm_response_status access(tlm::tlm_command command, std::uint64_t address, void* data,
                             unsigned bytes) {
    prepare(command, address, data, bytes);
    delay = sc_core::SC_ZERO_TIME;
    socket->b_transport(payload, delay);
    return payload.get_response_status();
  }
  std::uint32_t read(std::uint64_t address) {
    std::uint32_t word = 0;
    EXPECT_EQ(access(tlm::TLM_READ_COMMAND, address, &word, sizeof word), tlm::TLM_OK_RESPONSE);
    return word;
  }
  std::uint64_t read_64(std::uint64_t address) {
    std::uint64_t word = 0;
    EXPECT_EQ(access(tlm::TLM_READ_COMMAND, address, &word, sizeof word), tlm::TLM_OK_RESPONSE);
    return word;
  }
  void prepare(tlm::tlm_command command, std::uint64_t address, void* data, unsigned bytes) {
    payload.set_command(command);
    payload.set_address(address);
    payload.set_data_ptr(static_cast<unsigned char*>(data));
    payload.set_data_length(bytes);
    payload.set_streaming_width(bytes);
    payload.set_byte_enable_ptr(nullptr);
    payload.set_dmi_allowed(true);
    payload.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
  }
};

const sc_core::sc_time Clock(19841, sc_core::SC_PS);
const sc_core::sc_time LineTime = 1600 * Clock;
const sc_core::sc_time FrameTime = FrameLines * LineTime;

/// Chip, memory and host; we stand in the clock of reset.
struct TlmChip : testing::Test {
  TlmChip() {
    tlm::tlm_global_quantum::instance().set(FrameTime);
    chip.display_socket.bind(display.socket);
    host.socket.bind(chip.register_socket);
    sc_core::sc_start(Clock / 2);
  }
  void run_frames(int count) { sc_core::sc_start(count * FrameTime); }

  tlm_chip chip{"chip", {}};
  Memory display{"display", DisplayFrame + 4};
  Host host{"host"};
  std::uint32_t word = 0;
};

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

TEST_F(TlmChip, ShowsItsStateInRegisters) {
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

TEST_F(TlmChip, ShowsItsKnobsInTheOrderOfTheTable) {
  const knobs defaults;
  for (std::size_t i = 0; i < knob_table().size(); ++i)
    EXPECT_EQ(static_cast<int>(host.read(RegisterKnobs + 4 * i)), defaults.*knob_table()[i].member)
        << knob_table()[i].name;
  EXPECT_EQ(host.access(tlm::TLM_READ_COMMAND, RegisterKnobs + 4 * knob_table().size(), &word, 4),
            tlm::TLM_ADDRESS_ERROR_RESPONSE);
}

TEST_F(TlmChip, ShowsTheStatisticsOfTheLastWholeFrame) {
  tlm::tlm_global_quantum::instance().set(LineTime);  // or it may be a frame ahead
  EXPECT_EQ(host.read_64(RegisterCounters), 0u);
  chip.deposit(7223);
  run_frames(1);
  sc_core::sc_start(100 * LineTime);  // into the next
  const FrameStats want = CoreBench({}, 7223).render().stats;
  for (std::size_t i = 0; i < counter_table().size(); ++i)
    EXPECT_EQ(host.read_64(RegisterCounters + 8 * i), want.*counter_table()[i].member)
        << counter_table()[i].name;
  for (std::size_t i = 0; i < want.fifo_fill.size(); ++i) {
    EXPECT_EQ(host.read_64(RegisterFifoFill + 8 * i), want.fifo_fill[i]);
    EXPECT_EQ(host.read_64(RegisterStackDepth + 8 * i), want.stack_depth[i]);
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
}

TEST_F(TlmChip, ResetRegisterStartsTheDemoAnewBeforeTheNextLine) {
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

TEST_F(TlmChip, WritingZeroToTheResetRegisterDoesNothing) {
  run_frames(1);
  EXPECT_EQ(host.access(tlm::TLM_WRITE_COMMAND, RegisterReset, &word, 4), tlm::TLM_OK_RESPONSE);
  run_frames(1);
  EXPECT_EQ(host.read(RegisterFrame), 2u);
}

TEST_F(TlmChip, AWordTakesAClock) {
  std::uint32_t words[3];
  EXPECT_EQ(host.access(tlm::TLM_READ_COMMAND, RegisterFrame, words, sizeof words),
            tlm::TLM_OK_RESPONSE);
  EXPECT_EQ(host.delay, 3 * Clock);
  EXPECT_FALSE(host.payload.is_dmi_allowed());
}

TEST_F(TlmChip, RefusesWhatIsNoRegister) {
  for (const std::uint64_t address :
       {std::uint64_t{0x02}, std::uint64_t{0x24}, std::uint64_t{0x3fc}, std::uint64_t{0x1780},
        std::uint64_t{0x3000}, std::uint64_t{1} << 40})
    for (const auto command : {tlm::TLM_READ_COMMAND, tlm::TLM_WRITE_COMMAND})
      EXPECT_EQ(host.access(command, address, &word, 4), tlm::TLM_ADDRESS_ERROR_RESPONSE)
          << address;
  EXPECT_EQ(host.delay, sc_core::SC_ZERO_TIME);
}

TEST_F(TlmChip, RefusesToWriteWhatIsReadOnlyAndToReadWhatIsWriteOnly) {
  for (const std::uint64_t address : {std::uint64_t{RegisterFrame}, std::uint64_t{RegisterKnobs},
                                      std::uint64_t{RegisterCounters}})
    EXPECT_EQ(host.access(tlm::TLM_WRITE_COMMAND, address, &word, 4),
              tlm::TLM_COMMAND_ERROR_RESPONSE);
  EXPECT_EQ(host.access(tlm::TLM_READ_COMMAND, RegisterReset, &word, 4),
            tlm::TLM_COMMAND_ERROR_RESPONSE);
}

TEST_F(TlmChip, RefusesPartsOfWordsStreamingAndByteEnables) {
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

TEST_F(TlmChip, IgnoresTheIgnoreCommand) {
  word = 77;
  EXPECT_EQ(host.access(tlm::TLM_IGNORE_COMMAND, RegisterFrame, &word, 4), tlm::TLM_OK_RESPONSE);
  EXPECT_EQ(word, 77u);
}

TEST_F(TlmChip, DebugReadsAsManyWordsAsThereAreAndWritesNone) {
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

TEST_F(TlmChip, GivesNoDirectMemory) {
  tlm::tlm_dmi memory;
  host.prepare(tlm::TLM_READ_COMMAND, RegisterFrame, &word, 4);
  EXPECT_FALSE(host.socket->get_direct_mem_ptr(host.payload, memory));
  EXPECT_TRUE(memory.is_none_allowed());
  EXPECT_EQ(memory.get_start_address(), 0u);
  EXPECT_EQ(memory.get_end_address(), ~std::uint64_t{0});
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

// No table runs into the next.
TEST(CounterTable, TablesFitBetweenTheirAddresses) {
  EXPECT_LE(RegisterCounters + 8 * counter_table().size(), std::uint64_t{RegisterFifoFill});
  EXPECT_LE(RegisterKnobs + 4 * knob_table().size(), std::uint64_t{RegisterCounters});
  std::set<std::string> names;
  for (const counter_info& row : counter_table()) names.insert(row.name);
  EXPECT_EQ(names.size(), counter_table().size());
}

}  // namespace
}  // namespace racebeam
