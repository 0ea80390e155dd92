// Promises of sc/block/tlm_block.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/tlm_block.h"

#include <cstring>

#include "sc/block/tlm_block_map.h"
#include "tests/support/block_scenes.h"
#include "tests/support/picture_platform.h"

namespace racebeam {
namespace {

constexpr auto Write = tlm::TLM_WRITE_COMMAND, Read = tlm::TLM_READ_COMMAND;

struct TlmBlock : testing::Test {
  TlmBlock() {
    chip.display_socket.bind(display.socket);
    host.socket.bind(chip.host_socket);
    registers.socket.bind(chip.register_socket);
  }
  void run(std::int64_t clocks) { sc_core::sc_start(static_cast<double>(clocks) * Clock); }
  void put(std::uint64_t address, std::vector<float> numbers) {
    std::vector<std::uint32_t> words(numbers.size());
    std::memcpy(words.data(), numbers.data(), 4 * numbers.size());
    EXPECT_EQ(host.access(Write, address, words.data(), static_cast<unsigned>(4 * words.size())),
              tlm::TLM_OK_RESPONSE);
    EXPECT_EQ(host.delay, static_cast<double>(words.size()) * Clock) << "a clock a word";
  }
  void send(const block_tables& tables) {
    put(BlockHostEye, {tables.eye.begin(), tables.eye.end()});
    put(BlockHostLight, {tables.light.begin(), tables.light.end()});
    put(BlockHostScreen, {tables.screen.begin(), tables.screen.end()});
    for (std::size_t n = 0; n < tables.balls.size(); ++n) {
      const block_ball& b = tables.balls[n];
      put(BlockHostTable + BlockHostRow * n,
          {b.centre[0], b.centre[1], b.centre[2], b.radius, b.colour[0], b.colour[1], b.colour[2]});
    }
    host.write(BlockHostSpheres, static_cast<std::uint32_t>(tables.balls.size()));
  }

  const block_knobs knobs;
  const sc_core::sc_time Clock{clock_period_ps(block_knobs::clocks_per_pixel), sc_core::SC_PS};
  tlm_block chip{"chip", knobs};
  PictureDisplay display{"display", BlockDisplayColumns, BlockDisplayRows};
  WordInitiator host{"host"}, registers{"registers"};
};

TEST_F(TlmBlock, PictureCountersAndTimeAreTheMachines) {
  sc_core::sc_time done;
  display.on_picture = [&] { done = sc_core::sc_time_stamp(); };
  run(10);
  send(quad_tables());
  const std::int64_t clock = chip.machine().store().clock();
  block_machine machine(knobs);
  machine.go_to(clock);
  machine.draw(quad_tables());
  const block_counters& n = machine.counters();
  host.write(BlockHostControl, 1);
  EXPECT_EQ(host.read(BlockHostControl), 1u);
  run(static_cast<std::int64_t>(n.clocks) + 1000);
  EXPECT_EQ(chip.pictures(), 1u);
  EXPECT_EQ(chip.machine().picture(), machine.picture());
  EXPECT_EQ(done, static_cast<double>(1 + machine.store().clock()) * Clock);
  EXPECT_EQ(host.read(BlockHostControl), 0u);
  EXPECT_EQ(display.word(0), 0u);
  EXPECT_EQ(display.word(1), 640u);
  EXPECT_EQ(display.word(2), 480u);
  const std::size_t pixel = 3u * (240 * BlockDisplayColumns + 320);
  EXPECT_EQ(display.bytes[pixel], 47);
  EXPECT_EQ(display.bytes[pixel + 1], 139);
  EXPECT_EQ(display.bytes[pixel + 2], 93);

  EXPECT_EQ(registers.read(BlockRegisterId), BlockRegisterIdValue);
  EXPECT_EQ(registers.read(BlockRegisterPictures), 1u);
  EXPECT_EQ(registers.read(BlockRegisterKnobs), 4u) << "cores";
  EXPECT_EQ(registers.read(BlockRegisterCounters), static_cast<std::uint32_t>(n.clocks));
  for (int core = 0; core < knobs.cores; ++core)
    EXPECT_EQ(registers.read(BlockRegisterBusy + 8u * static_cast<unsigned>(core)),
              static_cast<std::uint32_t>(n.busy_by_core[static_cast<std::size_t>(core)]));
}

TEST_F(TlmBlock, TheHostReadsWhatItWrote) {
  run(10);
  send(quad_tables());
  EXPECT_EQ(host.read(BlockHostSpheres), 4u);
  EXPECT_EQ(host.read(BlockHostSize), 480u << 16 | 640);
  const std::uint32_t word = host.read(BlockHostTable + BlockHostRow + 4 * 3);
  float radius = 0;
  std::memcpy(&radius, &word, 4);
  EXPECT_EQ(radius, 0.75f);
}

TEST_F(TlmBlock, WhatTheHostMayNotDoHasAnErrorAndNoEffect) {
  run(10);
  send(quad_tables());
  std::uint32_t word = 65;
  EXPECT_EQ(host.access(Write, BlockHostSpheres, &word, 4), tlm::TLM_COMMAND_ERROR_RESPONSE);
  EXPECT_EQ(host.read(BlockHostSpheres), 4u);
  EXPECT_EQ(host.access(Write, BlockHostSize, &word, 4), tlm::TLM_COMMAND_ERROR_RESPONSE);
  EXPECT_EQ(host.access(Read, BlockHostEnd, &word, 4), tlm::TLM_ADDRESS_ERROR_RESPONSE);
  EXPECT_EQ(host.access(Read, BlockHostTable + 28, &word, 4), tlm::TLM_ADDRESS_ERROR_RESPONSE);
  EXPECT_EQ(host.access(Read, BlockHostEye + 1, &word, 4), tlm::TLM_ADDRESS_ERROR_RESPONSE);
  EXPECT_EQ(registers.access(Write, BlockRegisterKnobs, &word, 4), tlm::TLM_COMMAND_ERROR_RESPONSE);
  host.write(BlockHostControl, 1);
  word = 1;
  EXPECT_EQ(host.access(Write, BlockHostControl, &word, 4), tlm::TLM_COMMAND_ERROR_RESPONSE)
      << "a picture is drawn";
}

}  // namespace
}  // namespace racebeam
