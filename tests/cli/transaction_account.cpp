// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/cli/transaction_account.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "tb/monitor/vga_monitor.h"

namespace racebeam {

namespace {

std::string hex(int number) {
  char text[16];
  snprintf(text, sizeof text, "0x%x", static_cast<unsigned>(number));
  return text;
}

}  // namespace

TransactionAccount::TransactionAccount(const knobs& k, int frame, std::int64_t begin,
                                       std::int64_t end)
    : knobs_(k), line_clocks_(LinePixels * k.clocks_per_pixel), begin_(begin), end_(end) {
  chip_.clock_video(false, k);
  chip_.deposit(frame, k);
  for (int line = 0; line % FrameLines || line * line_clocks_ < end; ++line)
    run_line(frame + line / FrameLines, line);
}

std::map<std::uint64_t, std::string> TransactionAccount::changes(const std::string& path,
                                                                 std::uint64_t origin) const {
  const int period = clock_period_ps(knobs_.clocks_per_pixel);
  std::map<std::uint64_t, std::string> all;
  const auto stream = streams_.find(path);
  std::string last;
  for (std::int64_t n = begin_; n < end_; ++n) {
    const int id = stream == streams_.end() ? 0 : stream->second[n - begin_];
    if (n != begin_ && texts_[id] == last) continue;
    last = texts_[id];
    all[origin + static_cast<std::uint64_t>(n) * period] = last;
  }
  return all;
}

int TransactionAccount::count(const std::string& path) const {
  const auto found = counts_.find(path);
  return found == counts_.end() ? 0 : found->second;
}

std::string TransactionAccount::rgb(int colour) {
  return "rgb_" + std::to_string(colour >> 4) + std::to_string(colour >> 2 & 3) +
         std::to_string(colour & 3);
}

void TransactionAccount::run_line(int frame, int line) {
  const std::int64_t at = static_cast<std::int64_t>(line) * line_clocks_;
  const int y = chip_.vga_timing.v_pos_q, row = y - FirstVisibleLine;
  std::int64_t line_begin = -1, interval_begin = -1, restart_begin = -1;
  int next = 0, restart_pixel = 0;
  bool given_up = false, halfway = false;
  const auto stop = [&](std::int64_t end) {
    fill("tlm.tracer.line", line_begin, end, "line_" + std::to_string(y));
    line_begin = -1;
  };
  const auto end_restart = [&](std::int64_t end) {
    if (restart_begin >= 0)
      fill("tlm.tracer.restart", restart_begin, end, "from_" + std::to_string(restart_pixel));
    restart_begin = -1;
  };
  for (int clock = 0; clock < line_clocks_; ++clock) {
    const std::int64_t n = at + clock;
    const decision_datapath_core place = chip_.decision_datapath;
    const int first = chip_.subdivider.i1_q;
    chip_view v{};
    const int uo = chip_.clock_video(true, knobs_, &v);
    ASSERT_EQ(v.y, y);
    show(y, n, clock, uo);
    const bool tracing = v.run && !v.line_done && !v.line_end;
    if (tracing && line_begin < 0) line_begin = interval_begin = n;
    if (tracing && y != LastLine)
      put("tlm.tracer.room", n,
          "room_" + std::to_string(place.room_q) + "_depth_" +
              std::to_string(place.depth_q + halfway));
    halfway = v.descend && (v.tag & 7) == 7 && chip_.decision_datapath.second_q;
    if (tracing && v.emit && v.state != StateReturn) given_up = !v.wall;
    if (tracing && v.emit && v.ack) {
      ASSERT_EQ(first, next);
      std::string text = std::to_string(first) + ".." + std::to_string(v.i2) + "_colour_" +
                         std::to_string(chip_.interval_fifo.head_value_q);
      if (y != LastLine)
        text += "_room_" + std::to_string(place.room_q) + "_depth_" + std::to_string(place.depth_q);
      fill("tlm.tracer.interval", interval_begin, n + 1, text + (given_up ? "_given_up" : ""));
      end_restart(n + 1);
      interval_begin = n + 1;
      next = v.i2 + 1;
      if (v.i2 == LastPixel) stop(n + 1);
    }
    if (tracing && v.restart && v.i2 != LastPixel) {
      restart_begin = n;
      restart_pixel = v.i2 + 1;
    }
    if (!v.line_end || line_begin < 0) continue;
    fill("tlm.tracer.interval", interval_begin, n, std::to_string(next) + "..639_not_taken");
    end_restart(n);
    stop(n);
  }
  const std::int64_t next_line = at + line_clocks_;
  if (row >= 0 && row < VisibleRows)
    fill("tlm.display.line", at, next_line,
         "row_" + std::to_string(row) + "_at_" + hex(VisibleColumns * row) + "_640_bytes");
  if (y == LastLine)
    fill(
        "tlm.display.frame", next_line - line_clocks_ * FrameLines, next_line,
        "frame_" + std::to_string(frame) + "_at_" + hex(VisibleColumns * VisibleRows) + "_4_bytes");
}

void TransactionAccount::show(int y, std::int64_t n, int clock, int uo) {
  const int wide = knobs_.clocks_per_pixel, row = y - FirstVisibleLine;
  if (row < 0 || row >= VisibleRows || clock < 160 * wide || clock % wide != wide - 1) return;
  const int colour = colour_of_pins(static_cast<std::uint8_t>(uo));
  for (int i = 0; i < wide; ++i) put("tlm.display.shown", n - i, rgb(colour));
}

void TransactionAccount::put(const std::string& path, std::int64_t n, const std::string& text) {
  if (n < begin_ || n >= end_) return;
  auto& stream = streams_[path];
  stream.resize(static_cast<std::size_t>(end_ - begin_));
  const auto [id, fresh] = ids_.emplace(text, static_cast<int>(texts_.size()));
  if (fresh) texts_.push_back(text);
  stream[static_cast<std::size_t>(n - begin_)] = id->second;
}

void TransactionAccount::fill(const std::string& path, std::int64_t from, std::int64_t to,
                              const std::string& text) {
  ++counts_[path];
  for (std::int64_t n = from; n < to; ++n) put(path, n, text);
  if (from <= begin_ || from >= end_) return;
  const auto& stream = streams_[path];
  const auto at = static_cast<std::size_t>(from - begin_);
  EXPECT_NE(stream[at - 1], stream[at]) << path << " " << text;
}

}  // namespace racebeam
