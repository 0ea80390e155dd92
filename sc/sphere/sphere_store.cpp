// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/sphere_store.h"

#include <algorithm>

#include "sc/base/constants.h"

namespace racebeam {

namespace {

// Pixels of a line of vga_timing, and lines of a frame from its first.
constexpr int SyncBegins = 16, SyncEnds = 112, ActiveBegins = 160;
constexpr int FirstVisible = FirstVisibleLine - FirstLine;
constexpr int VsyncLine = FrameLines - 2;  // vsync falls at the end of its hsync

}  // namespace

sphere_store::sphere_store(const sphere_knobs& k)
    : k_(k),
      store_(k.store()),
      line_clocks_(std::int64_t{LinePixels} * k.clocks_per_pixel),
      frame_clocks_(line_clocks_ * FrameLines),
      memory_(std::size_t{1} << store_.address_bits()) {}

// In which run of like clocks clock_ is.
void sphere_store::find_run() {
  const std::int64_t in_frame = clock_ % frame_clocks_;
  const int line = static_cast<int>(in_frame / line_clocks_);
  const std::int64_t begin = clock_ - in_frame % line_clocks_;  // of the line
  const int n = k_.clocks_per_pixel;
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
    // The beam reads in the first clock of a pixel that it shows.
    const int shown = k_.wrap_right ? VisibleColumns : store_.picture_width;
    open_ = pixel >= ActiveBegins + shown || at % n != 0;
    if (pixel < ActiveBegins + shown)
      end = n == 1 ? (ActiveBegins + shown) * n : open_ ? (pixel + 1) * n : at + 1;
  }
  run_end_ = begin + end;
}

bool sphere_store::may_write() {
  if (clock_ >= run_end_) find_run();
  return open_;
}

void sphere_store::take(sphere_counters* n) {
  memory_[static_cast<std::size_t>(buffer_.take().address)] = buffer_.take().data;
  buffer_.clock({true, false, {}, true}, store_);
  --fill_;
  if (n) ++n->store_writes;
}

void sphere_store::go_to(std::int64_t clock, sphere_counters* n) {
  while (clock_ < clock) {
    const bool takes = fill_ && may_write();
    const std::int64_t end = fill_ == 0 ? clock : takes ? clock_ + 1 : std::min(clock, run_end_);
    if (n)
      n->buffer_fill[static_cast<std::size_t>(fill_)] += static_cast<std::uint64_t>(end - clock_);
    if (takes) take(n);
    clock_ = end;
  }
}

int sphere_store::put(int address, std::uint64_t word, sphere_counters& n) {
  const std::int64_t offered = clock_;
  while (fill_ == k_.write_buffer_depth && k_.when_full == WhenFullStall && !may_write())
    go_to(run_end_, &n);
  const int waited = static_cast<int>(clock_ - offered);
  const bool ready = may_write();
  const write_buffer_core::inputs in{true, true, {address, word}, ready};
  ++n.buffer_fill[static_cast<std::size_t>(fill_)];
  if (ready && fill_) {
    memory_[static_cast<std::size_t>(buffer_.take().address)] = buffer_.take().data;
    ++n.store_writes;
  }
  n.buffer_lost += static_cast<std::uint64_t>(buffer_.lost(in, store_));
  buffer_.clock(in, store_);
  fill_ = buffer_.fill(store_);
  ++n.words;
  n.buffer_stalls += static_cast<std::uint64_t>(waited);
  ++clock_;
  return waited;
}

std::uint64_t sphere_store::reads_before(std::int64_t clock) const {
  const std::int64_t shown = k_.wrap_right ? VisibleColumns : store_.picture_width;
  const std::int64_t in_frame = clock % frame_clocks_;
  const std::int64_t line = in_frame / line_clocks_;
  const std::int64_t at =
      in_frame % line_clocks_ - std::int64_t{ActiveBegins} * k_.clocks_per_pixel;
  const std::int64_t begun = (at + k_.clocks_per_pixel - 1) / k_.clocks_per_pixel;
  const bool visible = line >= FirstVisible && line < FirstVisible + VisibleRows;
  const std::int64_t whole = std::clamp<std::int64_t>(line - FirstVisible, 0, VisibleRows);
  const std::int64_t part = visible && at > 0 ? std::min(begun, shown) : 0;
  return static_cast<std::uint64_t>(clock / frame_clocks_ * VisibleRows * shown + whole * shown +
                                    part);
}

std::vector<std::uint64_t> sphere_store::picture() const {
  std::vector<std::uint64_t> all = memory_;
  write_buffer_core left = buffer_;
  while (left.take_valid()) {
    all[static_cast<std::size_t>(left.take().address)] = left.take().data;
    left.clock({true, false, {}, true}, store_);
  }
  return all;
}

}  // namespace racebeam
