// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/host/block_numbers.h"

#include "sc/block/codes.h"
#include "sc/block/numbers.h"

namespace racebeam {

std::vector<BlockNumber> block_numbers(const block_tables& tables) {
  std::vector<BlockNumber> all;
  int index = 0;
  const auto send = [&](const auto& values, int field) {
    for (const float value : values) all.push_back({float_bits(value), field++, index});
  };
  send(tables.eye, BlockEyeX);
  send(tables.light, BlockLightX);
  send(tables.screen, BlockScreenWidth);
  for (const block_ball& ball : tables.balls) {
    send(ball.centre, BlockCentreX);
    send(std::array{ball.radius}, BlockRadius);
    send(ball.colour, BlockRed);
    ++index;
  }
  return all;
}

}  // namespace racebeam
