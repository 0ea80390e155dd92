// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/monitor/vga_monitor.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace racebeam {
namespace {

constexpr int LostShare = 10;  // the syncs are lost if they are wrong in that part of the clocks

std::array<std::uint8_t, 256> make_colours() {
  std::array<std::uint8_t, 256> table{};
  for (int pins = 0; pins < 256; ++pins)
    table[pins] = static_cast<std::uint8_t>(colour_of_pins(pins));
  return table;
}

std::string must_be(const char* pin, bool seen, bool right) {
  return std::string(pin) + " is " + (seen ? "1" : "0") + ", must be " + (right ? "1" : "0");
}

std::string clocks(int begin, int end) {
  return "clocks " + std::to_string(begin) + ".." + std::to_string(end - 1);
}

}  // namespace

VgaMonitor::VgaMonitor(const Raster& raster, FrameCallback on_frame, VgaCrcs crcs,
                       VgaFaults* tolerated, const VgaPinout& pinout)
    : raster_(raster),
      on_frame_(std::move(on_frame)),
      crcs_(crcs),
      tolerated_(tolerated),
      pinout_(pinout) {
  frame_.width = raster_.columns;
  frame_.height = raster_.rows;
  frame_.bits = pinout_.bits;
  frame_.colours.resize(frame_.pixels() * frame_.colour_bytes());
}

void VgaMonitor::change(std::uint64_t clock, std::uint32_t pins) {
  advance(clock);
  const int in_frame = static_cast<int>(clock - frame_begin_);
  if (runs_.back().clock == in_frame) runs_.back().pins = pins;
  else if (runs_.back().pins != pins) runs_.push_back({in_frame, pins});
}

void VgaMonitor::advance(std::uint64_t clock) {
  if (clock < now_) throw std::logic_error("VgaMonitor: the clock runs backwards");
  now_ = clock;
  while (clock - frame_begin_ >= static_cast<std::uint64_t>(raster_.frame_clocks())) finish_frame();
}

void VgaMonitor::finish_frame() {
  const int frame_clocks = raster_.frame_clocks();
  frame_.index = frame_begin_ / frame_clocks;
  frame_begin_ += frame_clocks;
  whole_.swap(runs_);
  runs_.assign(1, {0, whole_.back().pins});
  whole_.push_back({frame_clocks, 0});  // where the last run ends

  const Run* run = whole_.data();
  const Run* const last = run + whole_.size() - 2;
  const std::uint64_t wrong = tolerated_ ? tolerated_->sync_clocks : 0;
  for (int y = raster_.first_line; y <= raster_.last_line(); ++y) finish_line(y, run, last);
  if (tolerated_ && (tolerated_->sync_clocks - wrong) * LostShare > std::uint64_t(frame_clocks))
    throw SyncError("the syncs are lost in frame " + std::to_string(frame_.index) + "; first, " +
                    tolerated_->first_sync);

  if (crcs_.image)
    frame_.image_crc = static_cast<std::uint32_t>(
        crc32(0, frame_.colours.data(), static_cast<uInt>(frame_.colours.size())));
  if (crcs_.pins) frame_.pins_crc = crc_of_pins();
  ++good_frames_;
  if (on_frame_) on_frame_(frame_);
}

/// Checks line `y` and takes its pixels; `run` covers its first clock and moves to its last.
void VgaMonitor::finish_line(int y, const Run*& run, const Run* last) {
  const Raster& r = raster_;
  const bool visible = r.visible_line(y);
  const bool above = r.vsync(y == r.first_line ? r.last_line() : y - 1), here = r.vsync(y);
  const bool known = frame_.index > 0 || y > r.first_line;  // vs is not reset
  const struct {
    int begin, end;  // clocks of the line
    bool hsync, black;
    const char* name;
  } regions[] = {{0, r.sync_begin, !r.hsync_pulse, true, "front porch"},
                 {r.sync_begin, r.sync_end, r.hsync_pulse, true, "sync pulse"},
                 {r.sync_end, r.active_begin, !r.hsync_pulse, true, "back porch"},
                 {r.active_begin, r.line_clocks(), !r.hsync_pulse, !visible, "visible columns"}};
  const int first = (y - r.first_line) * r.line_clocks();
  std::uint8_t* const row =
      visible
          ? &frame_
                 .colours[std::size_t(y - r.first_visible_line) * r.columns * frame_.colour_bytes()]
          : nullptr;
  for (const auto& region : regions) {
    Span span{region.begin, region.end, region.hsync, above, known, region.black, region.name};
    for (int clock = region.begin; clock < region.end;) {
      span.vsync = clock < r.vsync_at ? above : here;
      span.check_vsync = known || clock >= r.vsync_at;
      int end = std::min(run[1].clock - first, region.end);
      if (clock < r.vsync_at) end = std::min(end, r.vsync_at);
      check(span, y, clock, end - clock, run->pins);
      if (row) fill(row, r.column_at[clock], r.column_at[end], run->pins);
      clock = end;
      if (run[1].clock - first <= clock && run != last) ++run;
    }
  }
}

/// Columns `from` .. `to` - 1 of a row.
void VgaMonitor::fill(std::uint8_t* row, int from, int to, std::uint32_t pins) const {
  static const std::array<std::uint8_t, 256> tiny_colours = make_colours();
  if (pinout_.tiny) {
    std::fill(row + from, row + to, tiny_colours[pins & 0xff]);
    return;
  }
  const int bytes = frame_.colour_bytes();
  std::uint32_t colour = pinout_.colour(pins);
  for (int n = 0; n < bytes; ++n, colour >>= 8)
    for (int column = from; column < to; ++column)
      row[column * bytes + n] = static_cast<std::uint8_t>(colour);
}

void VgaMonitor::check(const Span& span, int y, int clock, int clocks, std::uint32_t pins) {
  const bool syncs = ((pins >> pinout_.hsync) & 1) == span.hsync &&
                     (!span.check_vsync || ((pins >> pinout_.vsync) & 1) == span.vsync);
  const bool black = !span.black || !(pins & pinout_.colours);
  if (syncs && black) return;
  if (!tolerated_) throw SyncError(fault(span, y, clock, pins));
  std::uint64_t& count = syncs ? tolerated_->colour_clocks : tolerated_->sync_clocks;
  std::string& first = syncs ? tolerated_->first_colour : tolerated_->first_sync;
  if (count == 0) first = fault(span, y, clock, pins);
  count += static_cast<std::uint64_t>(clocks);
}

std::string VgaMonitor::fault(const Span& span, int y, int clock, std::uint32_t pins) const {
  const bool hsync = (pins >> pinout_.hsync) & 1, vsync = (pins >> pinout_.vsync) & 1;
  const std::string from = " clock " + std::to_string(raster_.vsync_at);
  const int end = raster_.vsync_line + raster_.vsync_lines;
  std::string what = "frame " + std::to_string(frame_.index) + ", line " + std::to_string(y) +
                     ", clock " + std::to_string(clock) + ": ";
  if (hsync != span.hsync) {
    what += must_be("hsync", hsync, span.hsync) + " (" + span.name + ", " +
            clocks(span.begin, span.end) + ")";
  } else if (span.check_vsync && vsync != span.vsync) {
    what += must_be("vsync", vsync, span.vsync) + " (" +
            (span.vsync == raster_.vsync_pulse ? "sync pulse" : "outside the pulse") +
            ", which is line " + std::to_string(raster_.vsync_line) + from + " up to line " +
            std::to_string(end > raster_.last_line() ? end - raster_.lines : end) + from + ")";
  } else {
    const std::uint32_t colour = pinout_.colour(pins), most = (1u << pinout_.bits) - 1;
    what += "red, green, blue are " + std::to_string(colour >> 2 * pinout_.bits) + ", " +
            std::to_string(colour >> pinout_.bits & most) + ", " + std::to_string(colour & most) +
            ", must be 0, 0, 0 (" +
            (span.begin < raster_.active_begin ? span.name + (", " + clocks(span.begin, span.end))
                                               : "line " + std::to_string(y) + " is not visible") +
            ")";
  }
  return what;
}

std::uint32_t VgaMonitor::crc_of_pins() const {
  std::array<std::uint8_t, 4096> bytes;  // a multiple of what a clock has
  std::size_t filled = 0;
  uLong crc = crc32(0, nullptr, 0);
  const int each = pinout_.vsync < 8 ? 1 : 4;
  for (std::size_t i = 0; i + 1 < whole_.size(); ++i) {
    for (int left = whole_[i + 1].clock - whole_[i].clock; left > 0;) {
      const auto part = std::min<std::size_t>(left, (bytes.size() - filled) / each);
      if (each == 1) std::fill_n(&bytes[filled], part, static_cast<std::uint8_t>(whole_[i].pins));
      else
        for (std::size_t n = 0; n < part * each; ++n)
          bytes[filled + n] = static_cast<std::uint8_t>(whole_[i].pins >> n % 4 * 8);
      filled += part * each;
      left -= static_cast<int>(part);
      if (filled == bytes.size()) {
        crc = crc32(crc, bytes.data(), static_cast<uInt>(filled));
        filled = 0;
      }
    }
  }
  return static_cast<std::uint32_t>(crc32(crc, bytes.data(), static_cast<uInt>(filled)));
}

}  // namespace racebeam
