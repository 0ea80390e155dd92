// `racebeam trace --around`: what it finds is what the cores do there, and its windows are exact.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <optional>
#include <ostream>

#include "tests/cli/cli_trace_bench.h"
#include "tests/cli/traced_window.h"

namespace racebeam {
namespace {

using testing::HasSubstr;

constexpr int Crowded = 7223;  // open heights: a frame that starves much

struct Event {
  std::string trigger;
  int frame, line;  // searched from here to the end of the frame
  knobs k{};
  const char* units = "all=model";

  friend void PrintTo(const Event& event, std::ostream* out) {
    *out << event.trigger << " from " << place(event.frame, event.line) << ", " << event.units;
  }
  /// For the command line.
  std::vector<std::string> words() const {
    const std::string clocks = std::to_string(k.clocks_per_pixel);
    return {"--around", trigger, "--from", place(frame, line),
            "--use",    units,   "--set",  "clocks_per_pixel=" + clocks};
  }
  int line_clocks() const { return LinePixels * k.clocks_per_pixel; }
  /// The clock in which it happens, by the cores.
  std::optional<FrameClock> clock() const {
    chip_core chip;
    chip.clock(false, k);
    chip.deposit(frame, k);
    std::optional<FrameClock> found;
    int most = 0;
    for (int n = 0; n < FrameLines * line_clocks(); ++n) {
      chip_view view{};
      chip.clock(true, k, &view);
      if (view.y < line || view.y < FirstVisibleLine || view.y >= FirstVisibleLine + VisibleRows)
        continue;
      const bool tracing = view.run && !view.line_done;
      if (trigger == "max-stack"       ? tracing && view.sd > most
          : trigger == "first-starved" ? view.consume && view.starving
                                       : tracing && view.restart && !chip.subdivider.line_done_q) {
        found = FrameClock{frame, view.y, n % line_clocks()};
        most = view.sd;
        if (trigger != "max-stack") return found;
      }
    }
    return found;
  }
};

class CliTraceAroundTest : public CliTraceBench {
 protected:
  /// Traces around an event, and compares what is told and the window with the cores.
  void expect_window(const Event& event, const Window& window, std::vector<std::string> more) {
    for (const std::string& word : event.words()) more.push_back(word);
    const Wave wave = trace(more);
    EXPECT_THAT(said, HasSubstr(told(event)));
    TracedChip chip(event.k, window.from.frame);
    expect_the_cores(wave, window, chip);
  }
  static std::string told(const Event& event) {
    const FrameClock at = event.clock().value();
    return event.trigger + ": frame " + std::to_string(at.frame) + ", line " +
           std::to_string(at.line) + ", clock " + std::to_string(at.clock) + "\n";
  }
};

class AroundEvent : public CliTraceAroundTest, public testing::WithParamInterface<Event> {};

TEST_P(AroundEvent, IsItsClockByTheCoresAndTheLinesAroundIt) {
  const FrameClock at = GetParam().clock().value();
  const int last = GetParam().line_clocks() - 1;
  expect_window(GetParam(), {{at.frame, at.line - 1, 0}, {at.frame, at.line + 1, last}}, {});
  expect_window(GetParam(), {{at.frame, at.line, 0}, {at.frame, at.line, last}}, {"--lines", "0"});
}

TEST_P(AroundEvent, HasTheClocksBeforeAndAfterItThatWereAskedFor) {
  auto random = random_from(GetParam().frame);
  const int line_clocks = GetParam().line_clocks();
  const std::int64_t clock = GetParam().clock().value().ordinal(line_clocks);
  const int pre = below(random, 1000), post = below(random, 1000);
  expect_window(GetParam(),
                {place_at(clock - pre, line_clocks), place_at(clock + post, line_clocks)},
                {"--pre", std::to_string(pre), "--post", std::to_string(post)});
  expect_window(GetParam(), {place_at(clock, line_clocks), place_at(clock + 1, line_clocks)},
                {"--post", "1"});
}

knobs one_clock_per_pixel() {
  knobs k;
  k.clocks_per_pixel = 1;
  return k;
}

INSTANTIATE_TEST_SUITE_P(
    Events, AroundEvent,
    testing::Values(Event{"first-starved", Crowded, FirstLine},
                    Event{"first-starved", Crowded, -120, {}, "interval_fifo=rtl,subdivider=rtl"},
                    Event{"first-starved", 1234, 17, one_clock_per_pixel()},

                    Event{"first-restart", 11000, 0, one_clock_per_pixel()},
                    Event{"max-stack", Crowded, FirstLine},
                    Event{"max-stack", 5555, -273, one_clock_per_pixel(), "stacks=lockstep"}),
    [](const auto& info) {
      std::string name = info.param.trigger + "_" + std::to_string(info.param.frame) + "_" +
                         std::to_string(info.index);
      std::replace(name.begin(), name.end(), '-', '_');
      return name;
    });

TEST_F(CliTraceAroundTest, TheWindowEndsWhereTheShowDoes) {
  const Event early{"first-starved", 0, FirstLine, one_clock_per_pixel()};
  const FrameClock at = early.clock().value();
  expect_window(early, {{0, FirstLine, 0}, at}, {"--pre", "4000000"});
}

// The run is copied while it looks for the event, and a copy goes on to the window.
TEST_F(CliTraceAroundTest, AWindowOfACopyHasTheRegistersAndWiresOfTheCores) {
  const Wave wave = trace({"--when", "frame == 7223 && line == -100 && clock == 900", "--from",
                           "7223:-250", "--pre", "321", "--post", "123"});
  TracedChip chip({}, Crowded);
  expect_the_cores(wave, {{Crowded, -100, 579}, {Crowded, -100, 1023}}, chip);
}

TEST_F(CliTraceAroundTest, WhatTheCoresDoNotDoIsNotFound) {
  const Event calm{"first-starved", 60, 200};
  ASSERT_FALSE(calm.clock());
  std::vector<std::string> words = {"trace", "demo", "-o", "t.vcd"};
  for (const std::string& word : calm.words()) words.push_back(word);
  Program run(folder.path(), words);
  EXPECT_EQ(run.wait(), 2);
  EXPECT_THAT(run.err(), HasSubstr("nothing of first-starved from 60:200 to 60:251"));
}

}  // namespace
}  // namespace racebeam
