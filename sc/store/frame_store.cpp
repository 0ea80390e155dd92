// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/store/frame_store.h"

#include <algorithm>

#include "sc/base/constants.h"

namespace racebeam {

namespace {

// Pixels of a line of vga_timing, and lines of a frame from its first.
constexpr int SyncBegins = 16, SyncEnds = 112, ActiveBegins = 160;
constexpr int FirstVisible = FirstVisibleLine - FirstLine;
constexpr int VsyncLine = FrameLines - 2;  // vsync falls at the end of its hsync

}  // namespace

frame_store::frame_store(const store_knobs& k, int clocks_per_pixel)
    : k_(k),
      clocks_per_pixel_(clocks_per_pixel),
      shown_(k.wrap_right ? VisibleColumns : std::min(k.picture_width, VisibleColumns)),
      line_clocks_(std::int64_t{LinePixels} * clocks_per_pixel),
      frame_clocks_(line_clocks_ * FrameLines),
      memory_(std::size_t{1} << k.address_bits()) {}

// In which run of like clocks clock_ is.
void frame_store::find_run() {
  const std::int64_t in_frame = clock_ % frame_clocks_;
  const int line = static_cast<int>(in_frame / line_clocks_);
  const std::int64_t begin = clock_ - in_frame % line_clocks_;  // of the line
  const int n = clocks_per_pixel_;
  const int at = static_cast<int>(clock_ - begin), pixel = at / n;
  const bool visible = line >= FirstVisible && line < FirstVisible + VisibleRows;
  int end = LinePixels * n;
  if (k_.write_policy == WritePolicySync) {
    const int border = pixel < SyncBegins ? SyncBegins : pixel < SyncEnds ? SyncEnds : LinePixels;
    const bool vsync = line == VsyncLine + 1 || (line == VsyncLine && pixel >= SyncEnds) ||
                       (line == 0 && pixel < SyncEnds);
    open_ = vsync || border == SyncEnds;
    end = border * n;
  } else if (!visible || pixel < ActiveBegins) {
    open_ = true;
    if (visible) end = ActiveBegins * n;
  } else if (k_.write_policy == WritePolicyBlanking) {
    open_ = false;
  } else {
    // The beam reads in the first clocks of each group that it shows.
    const int reads = k_.group_words(), group = k_.group_pixels() * n;
    const int shown_end = (ActiveBegins + shown_) * n, in_group = (at - ActiveBegins * n) % group;
    open_ = at >= shown_end || in_group >= reads;
    if (at < shown_end) end = reads == group ? shown_end : at - in_group + (open_ ? group : reads);
  }
  run_end_ = begin + end;
}

bool frame_store::may_write() {
  if (clock_ >= run_end_) find_run();
  return open_;
}

void frame_store::take(store_counters* n) {
  memory_[static_cast<std::size_t>(buffer_.take().address)] = buffer_.take().data;
  buffer_.clock({true, false, {}, true}, k_);
  --fill_;
  if (n) ++n->store_writes;
}

void frame_store::go_to(std::int64_t clock, store_counters* n) {
  while (clock_ < clock) {
    const bool takes = fill_ && may_write();
    const std::int64_t end = fill_ == 0 ? clock : takes ? clock_ + 1 : std::min(clock, run_end_);
    if (n)
      n->buffer_fill[static_cast<std::size_t>(fill_)] += static_cast<std::uint64_t>(end - clock_);
    if (takes) take(n);
    clock_ = end;
  }
}

void frame_store::await_frame() {
  const auto to_next_frame = [&](std::int64_t clock) {
    go_to((clock + frame_clocks_ - 1) / frame_clocks_ * frame_clocks_, nullptr);
  };
  to_next_frame(clock_);
  while (buffer_.take_valid()) to_next_frame(clock_ + 1);
  std::fill(memory_.begin(), memory_.end(), 0);
}

bool frame_store::offer(int address, std::uint64_t word, store_counters& n) {
  ++n.buffer_fill[static_cast<std::size_t>(fill_)];
  const bool waits = must_wait(), ready = may_write();
  if (waits) {
    ++n.buffer_stalls;
  } else {
    const write_buffer_core::inputs in{true, true, {address, word}, ready};
    if (ready && fill_) {
      memory_[static_cast<std::size_t>(buffer_.take().address)] = buffer_.take().data;
      ++n.store_writes;
    }
    n.buffer_lost += static_cast<std::uint64_t>(buffer_.lost(in, k_));
    buffer_.clock(in, k_);
    fill_ = buffer_.fill(k_);
    ++n.words;
  }
  ++clock_;
  return !waits;
}

int frame_store::put(int address, std::uint64_t word, store_counters& n) {
  const std::int64_t offered = clock_;
  while (must_wait()) go_to(run_end_, &n);
  const int waited = static_cast<int>(clock_ - offered);
  n.buffer_stalls += static_cast<std::uint64_t>(waited);
  offer(address, word, n);
  return waited;
}

std::uint64_t frame_store::reads_before(std::int64_t clock) const {
  const std::int64_t reads = k_.group_words(), group = k_.group_pixels() * clocks_per_pixel_;
  const std::int64_t groups = shown_ / k_.group_pixels();  // of a line
  const std::int64_t in_frame = clock % frame_clocks_;
  const std::int64_t line = in_frame / line_clocks_;
  const std::int64_t at = in_frame % line_clocks_ - std::int64_t{ActiveBegins} * clocks_per_pixel_;
  const bool visible = line >= FirstVisible && line < FirstVisible + VisibleRows;
  const std::int64_t whole = std::clamp<std::int64_t>(line - FirstVisible, 0, VisibleRows);
  const std::int64_t begun = std::min(at / group, groups);
  const std::int64_t last = begun < groups ? std::min(at % group, reads) : 0;
  const std::int64_t part = visible && at > 0 ? begun * reads + last : 0;
  const std::int64_t lines = clock / frame_clocks_ * VisibleRows + whole;
  return static_cast<std::uint64_t>(lines * groups * reads + part);
}

std::vector<std::uint64_t> frame_store::picture() const {
  std::vector<std::uint64_t> all = memory_;
  write_buffer_core left = buffer_;
  while (left.take_valid()) {
    all[static_cast<std::size_t>(left.take().address)] = left.take().data;
    left.clock({true, false, {}, true}, k_);
  }
  return all;
}

}  // namespace racebeam
