// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/trace/beam_transaction_trace.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "sc/beam/tlm/tlm_map.h"
#include "tb/base/errors.h"

namespace racebeam {

namespace {

const std::string Idle = "-";

}  // namespace

TransactionTrace::TransactionTrace(const Raster& raster, int period_ps,
                                   const TraceSelection& selection,
                                   std::function<std::string(int)> part, VcdWriter& vcd)
    : raster_(raster),
      period_(static_cast<std::uint64_t>(period_ps)),
      part_(std::move(part)),
      vcd_(vcd),
      frame_signal_(vcd.add("beam", "frame", FrameBits)),
      line_signal_(vcd.add("beam", "line", 10)),
      part_signal_(vcd.add_text("beam", "part")) {
  constexpr std::pair<const char*, const char*> Names[Streams] = {
      {"tlm.tracer", "line"},    {"tlm.tracer", "interval"}, {"tlm.tracer", "room"},
      {"tlm.tracer", "restart"}, {"tlm.display", "shown"},   {"tlm.display", "line"},
      {"tlm.display", "frame"}};
  bool any = false;
  for (int stream = 0; stream < Streams; ++stream) {
    const auto [scope, name] = Names[stream];
    const bool wanted = selection.takes(std::string(scope) + "." + name);
    signals_[stream] = wanted ? vcd.add_text(scope, name) : None;
    any |= wanted;
  }
  if (!any)
    throw UsageError(
        "no signal is under --scope and --depth; names look like tlm.tracer.interval: try --scope "
        "tlm.tracer, or '*.line'");
  for (int clock = 0; clock < raster.line_clocks(); ++clock)
    if (raster.column_at[clock + 1] != raster.column_at[clock]) column_clocks_.push_back(clock);
}

void TransactionTrace::begin_frame(int frame, const TraceWindow& window) {
  const std::int64_t begin = TracePoint{frame, FirstLine, 0}.ordinal(raster_);
  const auto inside = [&](std::int64_t clock) {
    return static_cast<int>(std::clamp<std::int64_t>(clock - begin, 0, raster_.frame_clocks()));
  };
  frame_ = frame;
  from_ = inside(window.from.ordinal(raster_));
  to_ = inside(window.to.ordinal(raster_) + 1);
  for (auto& stream : transactions_) stream.clear();
}

void TransactionTrace::add(Stream stream, int begin, int end, const std::string& text) {
  begin = std::max(begin, from_);
  end = std::min(end, to_);
  if (signals_[stream] != None && begin < end) transactions_[stream].push_back({begin, end, text});
}

void TransactionTrace::started(int y, int clock) {
  line_begin_ = interval_begin_ = clock_of(y, clock);
  next_ = 0;
}

void TransactionTrace::entered(int y, int clock, int room, int depth) {
  end_room(clock_of(y, clock));
  room_begin_ = clock_of(y, clock);
  room_ = room;
  depth_ = depth;
}

void TransactionTrace::end_room(int end) {
  if (room_ != None) add(Room, room_begin_, end, fmt::format("room {} depth {}", room_, depth_));
  room_ = None;
}

void TransactionTrace::interval(const taken_interval& taken) {
  const int end = clock_of(taken.y, taken.clock) + 1;
  std::string text = fmt::format("{}..{} colour {}", taken.first, taken.last, taken.value);
  if (taken.y != LastLine) text += fmt::format(" room {} depth {}", taken.room, taken.depth);
  if (taken.given_up) text += " given up";
  add(Interval, interval_begin_, end, text);
  end_restart(end);
  interval_begin_ = end;
  next_ = taken.last + 1;
  if (taken.last != LastPixel) return;
  add(Line, line_begin_, end, fmt::format("line {}", taken.y));
  end_room(end);
  line_begin_ = None;
}

void TransactionTrace::restart(int y, int clock, int pixel) {
  restart_begin_ = clock_of(y, clock);
  restart_ = pixel;
}

void TransactionTrace::end_restart(int end) {
  if (restart_ != None) add(Restart, restart_begin_, end, fmt::format("from {}", restart_));
  restart_ = None;
}

// Reported in pieces.
void TransactionTrace::shown(int y, int column, int count, int colour) {
  if (y != run_y_ || column != run_end_ || colour != colour_) {
    add_run();
    run_y_ = y;
    run_ = column;
    colour_ = colour;
  }
  run_end_ = column + count;
}

void TransactionTrace::add_run() {
  if (run_ == run_end_) return;
  const int begin = run_ == 0 ? raster_.active_begin : column_clocks_[run_ - 1] + 1;
  add(Shown, clock_of(run_y_, begin), clock_of(run_y_, column_clocks_[run_end_ - 1]) + 1,
      fmt::format("rgb {}{}{}", colour_ >> 4, colour_ >> 2 & 3, colour_ & 3));
  run_ = run_end_ = 0;
}

void TransactionTrace::line_end(int y, int) {
  add_run();
  if (line_begin_ == None) return;
  const int end = clock_of(y, raster_.line_clocks() - 1);  // which resets the tracer
  add(Interval, interval_begin_, end, fmt::format("{}..{} not taken", next_, LastPixel));
  add(Line, line_begin_, end, fmt::format("line {}", y));
  end_room(end);
  end_restart(end);
  line_begin_ = None;
}

void TransactionTrace::written(int end, std::uint64_t address, const std::uint8_t* data,
                               unsigned bytes) {
  const bool line = address < DisplayFrame;
  const unsigned frame = data[0] | data[1] << 8 | data[2] << 16 | data[3] << 24;
  const std::string what =
      line ? fmt::format("row {}", address / VisibleColumns) : fmt::format("frame {}", frame);
  add(line ? DisplayedLine : DisplayedFrame,
      end - (line ? raster_.line_clocks() : raster_.frame_clocks()), end,
      fmt::format("{} at {:#x} {} bytes", what, address, bytes));
}

// Of all streams, in the order of time.
std::vector<TransactionTrace::Change> TransactionTrace::changes() const {
  std::vector<Change> all;
  for (int stream = 0; stream < Streams; ++stream) {
    const int signal = signals_[stream];
    if (signal == None) continue;
    int idle_from = from_;
    for (const Transaction& one : transactions_[stream]) {
      if (one.begin > idle_from) all.push_back({idle_from, signal, &Idle});
      all.push_back({one.begin, signal, &one.text});
      idle_from = one.end;
    }
    if (idle_from < to_) all.push_back({idle_from, signal, &Idle});
  }
  std::sort(all.begin(), all.end(), [](const Change& a, const Change& b) {
    return std::tie(a.clock, a.signal) < std::tie(b.clock, b.signal);
  });
  return all;
}

void TransactionTrace::end_frame() {
  const std::int64_t begin = TracePoint{frame_, FirstLine, 0}.ordinal(raster_);
  const auto time = [&](int clock) { return static_cast<std::uint64_t>(begin + clock) * period_; };
  vcd_.change(time(from_), frame_signal_, static_cast<std::uint64_t>(frame_));
  vcd_.change(time(from_), part_signal_, part_(frame_));
  int line_clock = from_;  // the next in which beam.line changes
  const auto show_lines = [&](int until) {
    while (line_clock <= until && line_clock < to_) {
      const int y = FirstLine + line_clock / raster_.line_clocks();
      vcd_.change(time(line_clock), line_signal_, static_cast<std::uint64_t>(y & low_bits(10)));
      line_clock = clock_of(y + 1, 0);
    }
  };
  for (const Change& one : changes()) {
    show_lines(one.clock);
    vcd_.change(time(one.clock), one.signal, *one.text);
  }
  show_lines(to_);
}

}  // namespace racebeam
