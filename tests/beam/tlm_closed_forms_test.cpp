// What the transaction-level chip computes at once, against the cores clock by clock, from random
// states.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <random>

#include "sc/beam/decision_datapath.h"
#include "sc/beam/interval_fifo.h"
#include "sc/beam/ray_stepper.h"
#include "sc/beam/scene_rom.h"
#include "sc/beam/sequencer.h"
#include "sc/beam/subdivider.h"
#include "sc/beam/tlm/line_raster.h"
#include "sc/beam/tlm/room_table.h"

namespace racebeam {
namespace {

class Random {
 public:
  int below(int count) { return static_cast<int>(engine_() % count); }

 private:
  std::mt19937 engine_{7};
};

/// A FIFO that a random beam and a random tracer have worked on, and settings to go with it.
struct UsedFifo {
  knobs k;
  interval_fifo_core fifo;

  explicit UsedFifo(Random& random) {
    k.fifo_entries = 3 + random.below(12);
    k.fifo_short_length_bits = 3 + random.below(8);
    fifo.clock({true, false, false, 0, 0}, k);
    for (int clocks = random.below(400); clocks > 0; --clocks)
      fifo.clock({false, random.below(3) == 0, random.below(2) == 0,
                  random.below(random.below(2) ? 8 : 200), random.below(4)},
                 k);
  }
};

// Time passes, in clocks with and without a pixel, up to the last that counts down.
TEST(FifoCountDown, IsTheClocksBetweenTwoEvents) {
  Random random;
  int counted = 0;
  for (int round = 0; round < 20000; ++round) {
    UsedFifo used(random);
    if (used.fifo.splitting(used.k)) continue;
    const int quiet = std::min(used.fifo.quiet_pixels(used.k), 700);
    const int pixels = quiet ? random.below(quiet + 1) : 0;
    interval_fifo_core expected = used.fifo;
    const int display = expected.display(used.k);
    for (int left = pixels; left > 0;) {
      const bool consume = random.below(2);
      left -= consume;
      expected.clock({false, consume, false, 0, 0}, used.k);
      ASSERT_EQ(expected.display(used.k), display);
      ASSERT_EQ(expected.fill(used.k), used.fifo.fill(used.k));
    }
    used.fifo.count_down(pixels, used.k);
    ASSERT_TRUE(used.fifo == expected) << "round " << round;
    counted += pixels;
  }
  EXPECT_GT(counted, 100000);
}

TEST(FifoPixels, AreThoseUntilItStarves) {
  Random random;
  int starved = 0;
  for (int round = 0; round < 5000; ++round) {
    UsedFifo used(random);
    int pixels = used.fifo.pixels(used.k);
    ASSERT_EQ(used.fifo.starving(used.k), pixels <= 0);
    if (pixels > 900) continue;
    for (; pixels > 0; --pixels) {
      ASSERT_FALSE(used.fifo.starving(used.k)) << "round " << round;
      used.fifo.clock({false, true, false, 0, 0}, used.k);
      for (int wait = random.below(3); wait > 0; --wait)
        used.fifo.clock({false, false, false, 0, 0}, used.k);
    }
    ASSERT_TRUE(used.fifo.starving(used.k)) << "round " << round;
    ++starved;
  }
  EXPECT_GT(starved, 1000);
}

// An offer that is refused changes nothing: the FIFO may go on as without it.
TEST(FifoOffer, RefusedLeavesNoTrace) {
  Random random;
  int refused = 0;
  for (int round = 0; round < 20000; ++round) {
    UsedFifo used(random);
    const bool consume = random.below(2);
    const interval_fifo_core::inputs offer{false, consume, true, random.below(640),
                                           random.below(4)};
    if (used.fifo.ack(offer, used.k)) continue;
    interval_fifo_core without = used.fifo;
    without.clock({false, consume, false, 0, 0}, used.k);
    used.fifo.clock(offer, used.k);
    ASSERT_TRUE(used.fifo == without) << "round " << round;
    ++refused;
  }
  EXPECT_GT(refused, 500);
}

TEST(PwmHold, IsTheClocksBetweenTwoBusyOnes) {
  constexpr int QuietX2 = 2;
  ASSERT_FALSE(pwm_sound_core::is_busy(QuietX2));
  Random random;
  for (int round = 0; round < 5000; ++round) {
    pwm_sound_core held;
    held.pwm_q = random.below(1 << 11);
    pwm_sound_core expected = held;
    const int clocks = random.below(1200);
    const bool low = !held.comb().pwm;
    const int rise = held.rises_in();
    for (int i = 0; i < clocks; ++i) {
      ASSERT_EQ(expected.comb().pwm, !low || i >= rise);
      expected.clock({true, 0, QuietX2, 0, 0});
    }
    held.hold(clocks);
    ASSERT_EQ(held.pwm_q, expected.pwm_q);
  }
}

TEST(Product, WithATableIsTheSumOfPartialProducts) {
  for (int x = 0; x < 1 << 8; ++x)
    for (int m = 0; m < 1 << 12; ++m)
      ASSERT_EQ(product(x, m, ChipCut), truncated_product(x, m, ChipCut)) << x << " * " << m;
}

// LEFT with dr2 not yet at i2: in the lock effect the beam moves it.
TEST(FollowBeam, IsTheClocksOfLeftInTheLockEffect) {
  Random random;
  const knobs k;
  for (int round = 0; round < 5000; ++round) {
    subdivider_core followed;
    followed.i1_q = random.below(600);
    followed.i2_q = followed.i1_q + random.below(640 - followed.i1_q);
    followed.idx2_q = random.below(640);
    followed.sd_q = random.below(5);
    followed.d1_q = random.below(16);
    const int pixels = 1 + random.below(20);
    if (followed.idx2_q <= followed.i2_q && followed.idx2_q + pixels > followed.i2_q) continue;
    subdivider_core expected = followed;
    subdivider_core::inputs in{};
    in.dec = expected.d1_q;
    in.mask = random.below(2) ? 14 : 1;
    in.starving = random.below(2);
    in.wall = random.below(2);
    in.lock = true;
    for (int pixel = 0; pixel < pixels; ++pixel)
      for (const bool consume : {false, true}) {
        in.consume = consume;
        const auto move = expected.comb(in, k);
        ASSERT_EQ(move.step, consume);
        expected.clock(in, move, k);
      }
    for (int pixel = 0; pixel < pixels; ++pixel) followed.follow_beam(1);
    ASSERT_TRUE(followed == expected) << "round " << round;
  }
}

TEST(RoomTable, AnswersAsSceneDoes) {
  for (int flags = 0; flags < 64; ++flags) {
    const auto rooms = room_table(flags);
    for (int id = 0; id <= SolidRoom; ++id) {
      const int row = id & low_bits(RoomBits);
      const auto want = scene_core::geometry(flags, id);
      ASSERT_EQ(rooms[row].half_size, want.half_size);
      ASSERT_EQ(rooms[row].position, want.position);
      for (int axis = 0; axis < 3; ++axis)
        for (const bool negative : {false, true})
          ASSERT_EQ(scene_rom_core::look(rooms, row, axis, negative, 0, LookThrough).room,
                    scene_core::neighbour(flags, id, axis, negative))
              << "flags " << flags << " room " << id;
    }
  }
}

// At every speed and pixel clock, from the first clock of a line to its last.
TEST(LineRaster, IsVgaTimingClockByClock) {
  for (int speed = 0; speed < 8; ++speed)
    for (const int clocks_per_pixel : {1, 2, 3, 8}) {
      knobs k;
      k.speed = speed;
      k.clocks_per_pixel = clocks_per_pixel;
      const line_raster raster(k);
      vga_timing_core timing;
      for (int line = 0; line < FrameLines; ++line) {
        const vga_timing_core begin = timing;
        int columns = 0;
        for (int clock = 0; clock < raster.size(); ++clock) {
          const vga_timing_core at = raster.at(clock, begin);
          ASSERT_EQ(at.h_region_q, timing.h_region_q);
          ASSERT_EQ(at.h_pos_q, timing.h_pos_q);
          ASSERT_EQ(at.half_q, timing.half_q);
          ASSERT_EQ(at.v_pos_q, timing.v_pos_q);
          ASSERT_EQ(at.vs_q, timing.vs_q) << "line " << line << " clock " << clock;
          const auto out = timing.comb({true, speed}, clocks_per_pixel);
          ASSERT_EQ(raster.x2[clock], out.x2);
          ASSERT_EQ(raster.columns_before[clock], columns);
          if (out.consume) {
            ASSERT_EQ(raster.column_clock[columns++], clock);
          }
          ASSERT_EQ(out.line_end, clock + 1 == raster.size());
          ASSERT_EQ(out.h_active, clock >= raster.active_begin);
          timing.clock({true, speed}, clocks_per_pixel);
        }
      }
    }
}

}  // namespace
}  // namespace racebeam
