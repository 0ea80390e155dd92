// Promises of sc/voxel/tlm_voxel.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/tlm_voxel.h"

#include "sc/voxel/tlm_voxel_map.h"
#include "tb/host/voxel_player.h"
#include "tests/support/picture_platform.h"

namespace racebeam {
namespace {

constexpr auto Write = tlm::TLM_WRITE_COMMAND, Read = tlm::TLM_READ_COMMAND;

voxel_knobs small_knobs() {
  voxel_knobs k;
  k.picture_width = 64;
  k.picture_height = 48;
  return k;
}

struct TlmVoxel : testing::Test {
  TlmVoxel() {
    chip.display_socket.bind(display.socket);
    host.socket.bind(chip.host_socket);
    registers.socket.bind(chip.register_socket);
  }
  void run(std::int64_t clocks) { sc_core::sc_start(static_cast<double>(clocks) * Clock); }
  void put(std::uint64_t address, const vec3& values) {
    for (std::size_t n = 0; n < 3; ++n)
      host.write(address + 4 * n, static_cast<std::uint32_t>(values[n]));
  }
  void send_world() {
    std::vector<std::uint32_t> columns = program.columns;
    EXPECT_EQ(host.access(Write, VoxelHostColumns, columns.data(),
                          static_cast<unsigned>(4 * columns.size())),
              tlm::TLM_OK_RESPONSE);
    EXPECT_EQ(host.delay, static_cast<double>(columns.size()) * Clock) << "a clock a word";
    run(static_cast<std::int64_t>(columns.size()));
    for (std::size_t n = 0; n < program.palette.size(); ++n)
      host.write(VoxelHostPalette + 4 * n, static_cast<std::uint32_t>(program.palette[n]));
    run(1000);
  }
  void build_all() {
    host.write(VoxelHostLow, 0);
    host.write(VoxelHostHigh, 64 << 16 | 64);
    EXPECT_EQ(host.read(VoxelHostStatus), 1u);
    run(1'000'000);
    EXPECT_EQ(host.read(VoxelHostStatus), 0u);
  }
  void send_view() {
    const voxel_view& view = program.view(0);
    put(VoxelHostOrigin, view.origin);
    put(VoxelHostD00, view.d00);
    put(VoxelHostDx, view.dx);
    put(VoxelHostDy, view.dy);
    put(VoxelHostLight, view.light);
  }

  const VoxelProgram& program = builtin_voxel_program();
  const voxel_knobs knobs = small_knobs();
  const sc_core::sc_time Clock{clock_period_ps(voxel_knobs::clocks_per_pixel), sc_core::SC_PS};
  tlm_voxel chip{"chip", knobs};
  PictureDisplay display{"display", VoxelDisplayColumns, VoxelDisplayRows};
  WordInitiator host{"host"}, registers{"registers"};
};

TEST_F(TlmVoxel, APictureOfAWorldThatTheHostBuiltIsThePlayers) {
  run(10);
  send_world();
  build_all();
  send_view();
  host.write(VoxelHostStart, 1);
  EXPECT_EQ(host.read(VoxelHostStatus), 2u);
  run(1'000'000);
  ASSERT_EQ(chip.pictures(), 1u);
  VoxelPlayer player(program, knobs);
  player.draw();
  EXPECT_EQ(chip.machine().picture(), player.machine().picture());
  EXPECT_EQ(chip.counters().walk_clocks, 312737u);
  EXPECT_EQ(chip.counters().build_clocks, player.machine().counters().build_clocks);
  EXPECT_EQ(chip.counters().host_clocks, player.machine().counters().host_clocks);
  EXPECT_EQ(display.word(1), 64u);
  EXPECT_EQ(display.word(2), 48u);
  EXPECT_EQ(registers.read(VoxelRegisterId), VoxelRegisterIdValue);
  EXPECT_EQ(registers.read(VoxelRegisterPictures), 1u);
  EXPECT_EQ(registers.read(VoxelRegisterKnobs), 100u) << "max_outer";
  EXPECT_EQ(registers.read(VoxelRegisterCounters),
            static_cast<std::uint32_t>(chip.counters().clocks));
}

TEST_F(TlmVoxel, TheHostReadsWhatItWroteAndWhatTheWorldIs) {
  run(10);
  send_view();
  EXPECT_EQ(static_cast<int>(host.read(VoxelHostD00)), program.view(0).d00[0]);
  host.write(VoxelHostColumns + 4 * 65, 0x010203);
  EXPECT_EQ(host.read(VoxelHostColumns + 4 * 65), 0x010203u);
  EXPECT_EQ(host.read(VoxelHostSize), 64u << 16 | 64);
  EXPECT_EQ(host.read(VoxelHostVoxel), 1u << 16 | 4 << 8 | 1);
  EXPECT_EQ(host.read(VoxelHostLevels), 5u);
}

TEST_F(TlmVoxel, WhatTheHostMayNotDoHasAnErrorAndNoEffect) {
  run(10);
  std::uint32_t word = 1;
  EXPECT_EQ(host.access(Write, VoxelHostSize, &word, 4), tlm::TLM_COMMAND_ERROR_RESPONSE);
  EXPECT_EQ(host.access(Write, VoxelHostStatus, &word, 4), tlm::TLM_COMMAND_ERROR_RESPONSE);
  EXPECT_EQ(host.access(Read, VoxelHostColumns + 4 * 64 * 64, &word, 4),
            tlm::TLM_ADDRESS_ERROR_RESPONSE);
  EXPECT_EQ(host.access(Read, VoxelHostOrigin + 1, &word, 4), tlm::TLM_ADDRESS_ERROR_RESPONSE);
  EXPECT_EQ(registers.access(Write, VoxelRegisterKnobs, &word, 4), tlm::TLM_COMMAND_ERROR_RESPONSE);
  for (const std::uint32_t high : {0u, 65u << 16 | 64, 64u << 16 | 65}) {
    word = high;
    EXPECT_EQ(host.access(Write, VoxelHostHigh, &word, 4), tlm::TLM_COMMAND_ERROR_RESPONSE)
        << "not in the world";
  }
  build_all();
  host.write(VoxelHostHigh, 64 << 16 | 64);
  word = 1;
  EXPECT_EQ(host.access(Write, VoxelHostStart, &word, 4), tlm::TLM_COMMAND_ERROR_RESPONSE)
      << "it builds";
  EXPECT_EQ(host.access(Write, VoxelHostColumns, &word, 4), tlm::TLM_COMMAND_ERROR_RESPONSE);
  EXPECT_EQ(chip.pictures(), 0u);
}

}  // namespace
}  // namespace racebeam
