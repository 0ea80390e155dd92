// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/cli/traced_window.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace racebeam {

FrameClock place_at(std::int64_t ordinal, int line_clocks) {
  const std::int64_t line = ordinal / line_clocks;
  return {static_cast<int>(line / FrameLines), FirstLine + static_cast<int>(line % FrameLines),
          static_cast<int>(ordinal % line_clocks)};
}

std::minstd_rand random_from(int seed) {
  std::minstd_rand random(static_cast<unsigned>(seed));
  random.discard(10);
  return random;
}

int below(std::minstd_rand& random, int count) {
  return static_cast<int>((random() >> 8) % static_cast<unsigned>(count));
}

Window random_window(std::minstd_rand& random, int frames, int line_clocks, bool over_the_end) {
  const int frame = below(random, frames - 1), frame_clocks = FrameLines * line_clocks;
  const int clock =
      over_the_end ? frame_clocks - 1 - below(random, line_clocks) : below(random, frame_clocks);
  const std::int64_t first = static_cast<std::int64_t>(frame) * frame_clocks + clock;
  const int more = (over_the_end ? line_clocks : 0) + below(random, line_clocks);
  return {place_at(first, line_clocks), place_at(first + more, line_clocks)};
}

void expect_the_cores(const Wave& wave, const Window& window, TracedChip& chip,
                      const std::vector<std::string>& rtl_beside) {
  const int line_clocks = chip.line_clocks();
  const std::int64_t first = window.from.ordinal(line_clocks),
                     last = window.to.ordinal(line_clocks);
  const auto period = static_cast<std::uint64_t>(chip.period());
  const auto time = [period](std::int64_t clock) {
    return static_cast<std::uint64_t>(clock) * period;
  };
  EXPECT_EQ(wave.scale, "1ps");
  EXPECT_EQ(wave.begin, time(first));
  EXPECT_EQ(wave.end, time(last + 1));

  struct Shown {
    std::string path;
    const Wave::Signal* signal;
    probe core;
  };
  std::vector<Shown> all;
  const auto expect = [&](const std::string& path, const probe& core) {
    all.push_back({path, &wave[path], core});
    EXPECT_EQ(all.back().signal->bits, core.bits) << path;
  };
  for (const probe& one : chip.wires()) expect(one.name, one);
  for (const probe& one : chip.registers()) {
    expect(one.name, one);
    for (const std::string& unit : rtl_beside)
      if (const std::string scope = "chip." + unit + "."; one.name.rfind(scope, 0) == 0)
        expect(scope + "rtl." + one.name.substr(scope.size()), one);
  }
  chip.skip(first - FrameClock{window.from.frame, FirstLine, 0}.ordinal(line_clocks));
  for (std::int64_t clock = first; clock <= last; ++clock, chip.step()) {
    chip.look();
    for (const Shown& one : all)
      ASSERT_EQ(one.signal->number(time(clock)), one.core.read())
          << one.path << " in " << place_at(clock, line_clocks).text();
    ASSERT_EQ(wave["chip.clk_i"].at(time(clock)), "1");
    ASSERT_EQ(wave["chip.clk_i"].at(time(clock) + period / 2), "0");
  }
}

int expect_ports_are_wires(const Wave& wave) {
  int ports = 0;
  for (const auto& [path, signal] : wave.signals) {
    const auto dot = path.rfind('.');
    if (path.rfind("chip.u_", 0) != 0 || std::count(path.begin(), path.end(), '.') != 2) continue;
    std::string name = path.substr(dot + 1);
    const auto line = name.rfind('_');
    const std::string end = line == std::string::npos ? "" : name.substr(line);
    if (end != "_i" && end != "_o" && end != "_ni" && end != "_no") continue;
    ++ports;
    const std::string wire = "chip." + name.substr(0, line) + (end.size() == 3 ? "_n" : "");
    const auto at = wave.signals.find(wire);
    EXPECT_TRUE((at == wave.signals.end() ? wave["chip." + name] : at->second) == signal) << path;
  }
  return ports;
}

int expect_both_sides(const Wave& wave, const std::string& scope) {
  const std::string rtl = scope + ".rtl.";
  int both = 0;
  for (const auto& [path, signal] : wave.signals) {
    if (path.rfind(rtl, 0) != 0) continue;
    const auto model = wave.signals.find(scope + "." + path.substr(rtl.size()));
    if (model == wave.signals.end()) continue;
    ++both;
    EXPECT_TRUE(model->second == signal) << path;
  }
  return both;
}

}  // namespace racebeam
