// Promises of sc/sphere/tlm_sphere.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/tlm_sphere.h"

#include "tests/sphere/four_scene.h"
#include "tests/sphere/tlm_sphere_platform.h"

namespace racebeam {
namespace {

constexpr auto Write = tlm::TLM_WRITE_COMMAND, Read = tlm::TLM_READ_COMMAND;

using TlmSphere = SpherePlatform;

/// The words of scene four, each burst two clocks after the last.
void send_four(WordInitiator& host, const sc_core::sc_time& clock) {
  const std::vector<sphere_row> spheres = four_spheres();
  const auto word = [](int value) { return static_cast<std::uint32_t>(value); };
  for (int n = 0; n < 4; ++n) {
    const sphere_row& s = spheres[static_cast<std::size_t>(n)];
    std::uint32_t words[] = {word(4 << 4 | n),  word(s.color_word()),
                             word(s.centre[0]), word(s.centre[1]),
                             word(s.centre[2]), word(s.reflect),
                             word(s.radius),    word(s.radius2),
                             word(s.inverse),   1};
    EXPECT_EQ(host.access(Write, SphereHostSphere, words, sizeof words), tlm::TLM_OK_RESPONSE);
    EXPECT_EQ(host.delay, 20 * clock) << "two clocks a word";
    sc_core::sc_start(host.delay);
    host.write(SphereHostValid, 0);
    sc_core::sc_start(host.delay);
  }
  host.write(SphereHostValid, 1);
  sc_core::sc_start(host.delay);
  host.write(SphereHostValid, 0);
  sc_core::sc_start(host.delay);
}

TEST_F(TlmSphere, PictureCountersAndTimeAreTheCores) {
  sphere_core core({}, tables, board);
  core.load(four_spheres());
  core.draw(board);
  sc_core::sc_time done;
  display.on_picture = [&] { done = sc_core::sc_time_stamp(); };
  run_to(0);
  send_four(host, Clock);
  EXPECT_EQ(host.read(SphereHostDone), 0u);
  run_to(static_cast<std::int64_t>(core.counters().clocks) + 1000);
  EXPECT_EQ(chip.pictures(), 1u);
  EXPECT_EQ(chip.core().picture(), core.picture());
  EXPECT_EQ(chip.counters().clocks, core.counters().clocks);
  EXPECT_EQ(chip.counters().words, 320u * 240);
  EXPECT_EQ(chip.counters().host_faults, 0u);
  EXPECT_EQ(done, (1 + chip.counters().host_clocks + core.counters().clocks) * Clock);
  EXPECT_EQ(host.read(SphereHostDone), 1u);
  EXPECT_EQ(display.word(0), 0u);
  EXPECT_EQ(display.word(1), 320u);
  EXPECT_EQ(display.word(2), 240u);
  const auto words = core.picture();
  for (int y = 0; y < 240; ++y)
    for (int x = 0; x < 320; ++x) {
      const auto word = words[static_cast<std::size_t>(core.address(x, y))];
      const int dac = static_cast<int>(word >> 10 & 31) << 5 | (word >> 15 ? 31 : 0);
      ASSERT_EQ(display.bytes[3u * (VisibleColumns * y + x)], dac >> 2) << x << "," << y;
    }
}

TEST_F(TlmSphere, WithoutACpuTheBuiltInSceneIsDrawn) {
  run_to(HostPatience + 10'000'000);
  EXPECT_GE(chip.pictures(), 3u);
  EXPECT_EQ(chip.core().table().last_q, 4);
  EXPECT_EQ(chip.core().table().row(1).centre, four_spheres()[1].centre);
}

TEST_F(TlmSphere, ValidOutsideHostIsNeitherLostNorTakenTwice) {
  run_to(0);
  send_four(host, Clock);
  host.write(SphereHostSphere, 0x21);
  host.write(SphereHostX1, 7);
  host.write(SphereHostValid, 1);
  while (chip.pictures() == 0) sc_core::sc_start(10'000 * Clock);
  sc_core::sc_start(100 * Clock);
  EXPECT_EQ(host.read(SphereHostDone), 1u) << "one entry of three";
  EXPECT_EQ(chip.core().table().row(1).centre[0], 7);
  EXPECT_EQ(chip.core().table().row(0).centre, four_spheres()[0].centre);
  host.write(SphereHostValid, 0);
  for (const int valid : {1, 0, 1, 0}) {
    sc_core::sc_start(2 * Clock);
    host.write(SphereHostValid, static_cast<unsigned>(valid));
  }
  sc_core::sc_start(2 * Clock);
  EXPECT_EQ(host.read(SphereHostDone), 0u) << "the second sphere, and the light";
  EXPECT_EQ(chip.core().counters().host_faults, 0u);
}

TEST_F(TlmSphere, FaultsOfTheHostAreCountedAndNothingHangs) {
  run_to(0);
  host.write(SphereHostSphere, 0x2f);  // an index above the number
  for (int edge = 0; edge < 3; ++edge)
    for (const unsigned valid : {1, 0}) {
      host.write(SphereHostValid, valid);
      sc_core::sc_start(host.delay);
    }
  host.write(SphereHostValid, 1);  // and taken back while it draws
  sc_core::sc_start(50 * Clock);
  host.write(SphereHostValid, 0);
  while (chip.pictures() == 0) sc_core::sc_start(100'000 * Clock);
  EXPECT_EQ(chip.counters().host_faults, 2u) << "a picture has those before it";
  const std::uint64_t of_first = SphereRegisterCounters + 8 * 20;
  EXPECT_EQ(std::string(sphere_counter_infos()[20].name), "host_faults");
  EXPECT_EQ(registers.read(of_first), 2u);
  for (const unsigned valid : {1, 0, 1, 0, 1, 0}) {
    host.write(SphereHostValid, valid);
    sc_core::sc_start(host.delay);
  }
  while (chip.pictures() == 1) sc_core::sc_start(100'000 * Clock);
  EXPECT_EQ(registers.read(of_first), 3u) << "the one taken back, and two indices";
}

TEST_F(TlmSphere, ErrorsAreAnsweredAndChangeNothing) {
  run_to(0);
  std::uint32_t words[20] = {};
  EXPECT_EQ(host.access(Write, SphereHostEnd, words, 4), tlm::TLM_ADDRESS_ERROR_RESPONSE);
  EXPECT_EQ(host.access(Write, 2, words, 4), tlm::TLM_ADDRESS_ERROR_RESPONSE);
  EXPECT_EQ(host.access(Read, SphereHostColor, words, 4), tlm::TLM_COMMAND_ERROR_RESPONSE);
  EXPECT_EQ(host.access(Write, SphereHostDone, words, 4), tlm::TLM_COMMAND_ERROR_RESPONSE);
  EXPECT_EQ(host.access(Write, SphereHostValid, words, 8), tlm::TLM_COMMAND_ERROR_RESPONSE);
  EXPECT_EQ(host.access(Write, 0, words, 3), tlm::TLM_BURST_ERROR_RESPONSE);
  EXPECT_EQ(host.access(Write, 0, words, 0), tlm::TLM_BURST_ERROR_RESPONSE);
  host.payload.set_byte_enable_ptr(reinterpret_cast<std::uint8_t*>(words));
  host.payload.set_data_length(4);
  host.socket->b_transport(host.payload, host.delay);
  EXPECT_EQ(host.payload.get_response_status(), tlm::TLM_BYTE_ENABLE_ERROR_RESPONSE);
  EXPECT_EQ(registers.access(Read, 0xc, words, 4), tlm::TLM_ADDRESS_ERROR_RESPONSE);
  EXPECT_EQ(registers.access(Write, SphereRegisterId, words, 4), tlm::TLM_COMMAND_ERROR_RESPONSE);
  EXPECT_EQ(registers.access(Read, SphereRegisterReset, words, 4), tlm::TLM_COMMAND_ERROR_RESPONSE);
  EXPECT_EQ(host.access(Read, SphereHostRotz, words, 8), tlm::TLM_OK_RESPONSE);
  EXPECT_EQ(words[1], 1u);
}

TEST_F(TlmSphere, RegistersShowKnobsCountersAndTheBoard) {
  run_to(0);
  EXPECT_EQ(registers.read(SphereRegisterId), SphereRegisterIdValue);
  EXPECT_EQ(static_cast<int>(registers.read(SphereRegisterPeriod)), clock_period_ps(1));
  const sphere_knobs k;
  for (std::size_t n = 0; n < sphere_knob_table().size(); ++n)
    EXPECT_EQ(static_cast<int>(registers.read(SphereRegisterKnobs + 4 * n)),
              k.*sphere_knob_table()[n].member);
  registers.write(SphereRegisterSwitches, 1 << 17);
  registers.write(SphereRegisterKeys, 15 & ~1);
  EXPECT_EQ(registers.read(SphereRegisterSwitches), 1u << 17);
  send_four(host, Clock);
  while (chip.pictures() == 0) sc_core::sc_start(100'000 * Clock);
  EXPECT_EQ(chip.core().inputs().light_q[0], 16 * 4096);
  EXPECT_EQ(chip.core().inputs().screen_q, 8 * 4096 + 256);
  const frame_counts counts = counted(chip.counters());
  for (std::size_t n = 0; n < counts.counters.size(); ++n)
    EXPECT_EQ(registers.read(SphereRegisterCounters + 8 * n), counts.counters[n]) << n;
  EXPECT_EQ(registers.read(SphereRegisterFill), counts.histograms[0][0]);
  registers.write(SphereRegisterReset, 1);
  sc_core::sc_start(3 * Clock);
  EXPECT_EQ(chip.core().inputs().light_q[0], 15 * 4096);
  EXPECT_LE(registers.read(SphereRegisterClocks), 3u);
}

}  // namespace
}  // namespace racebeam
