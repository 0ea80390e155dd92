// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/tt/pins_report.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "tb/base/counted.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* Row = "{:>5}  {:>7}  {:>14}";
constexpr const char* PinRow = "{:<7} {:<6} {:>12} {:>8} {:>8}\n";
constexpr const char* VgaPinNames[] = {"R1", "G1", "B1", "vsync", "R0", "G0", "B0", "hsync"};

std::string pin_name(int pin) { return fmt::format("{}[{}]", pin < 8 ? "uo" : "uio", pin % 8); }

const char* polarity(bool pulse) { return pulse ? "positive" : "negative"; }

double share(std::uint64_t part, std::uint64_t all) {
  return all ? static_cast<double>(part) / static_cast<double>(all) : 0;
}

Json json_of(const PinStats& stats) {
  const auto rounded = [&](std::uint64_t clocks) {
    return std::round(share(clocks, stats.clocks) * 1e6) / 1e6;
  };
  Json pins;
  for (int pin = 0; pin < PinStats::Pins; ++pin)
    pins[pin_name(pin)] = {{"toggles", stats.toggles[pin]},
                           {"high", rounded(stats.high[pin])},
                           {"enabled", rounded(stats.enabled[pin])}};
  return {{"clocks", stats.clocks}, {"colours", stats.colours.count()}, {"pins", pins}};
}

std::uint64_t uo_toggles(const PinStats& stats) {
  std::uint64_t sum = 0;
  for (int pin = 0; pin < 8; ++pin) sum += stats.toggles[pin];
  return sum;
}

}  // namespace

PinsReport::PinsReport(const TtProject& project, TtInputs inputs, const FoundFrames& found,
                       bool crc)
    : project_(project), inputs_(std::move(inputs)), found_(found), crc_(crc) {}

void PinsReport::add(int frame, const TtBench::Frame& seen) {
  Json json = {{"frame", frame}};
  json.update(json_of(seen.stats));
  if (crc_) {
    json["image_crc32"] = fmt::format("{:08x}", seen.picture.image_crc);
    json["pins_crc32"] = fmt::format("{:08x}", seen.picture.pins_crc);
  }
  frames_.push_back(json.dump());
  total_ += seen.stats;
}

std::string PinsReport::text(const VgaFaults& faults, const std::string& against) const {
  const Raster& raster = found_.raster;
  const Json chip = {{"folder", project_.folder},
                     {"top_module", project_.top},
                     {"hash", project_.hash},
                     {"clock_hz", std::llround(found_.clock_hz)},
                     {"clock_assumed", found_.clock_assumed},
                     {"ui_in", inputs_.start().ui},
                     {"uio_in", inputs_.start().uio},
                     {"input_changes", inputs_.changes().size()}};
  const Json syncs = {{"mode", found_.mode},
                      {"width", raster.columns},
                      {"height", raster.rows},
                      {"frames_per_second", std::round(found_.frames_per_second() * 1e3) / 1e3},
                      {"clocks_per_pixel", std::round(found_.clocks_per_pixel * 1e6) / 1e6},
                      {"hsync",
                       {{"period_clocks", raster.line_clocks()},
                        {"pulse_clocks", raster.sync_end - raster.sync_begin},
                        {"polarity", polarity(raster.hsync_pulse)}}},
                      {"vsync",
                       {{"period_clocks", raster.frame_clocks()},
                        {"pulse_clocks", raster.vsync_lines * raster.line_clocks()},
                        {"polarity", polarity(raster.vsync_pulse)}}},
                      {"first_frame_clock", found_.first},
                      {"picture_late_clocks", found_.picture_late}};
  const Json broken = {{"sync_clocks", faults.sync_clocks},
                       {"first_sync", faults.first_sync},
                       {"colour_clocks", faults.colour_clocks},
                       {"first_colour", faults.first_colour}};
  Json total = {{"frames", frames()}};
  total.update(json_of(total_));
  std::string rows;
  for (const std::string& frame : frames_) rows += (rows.empty() ? "\n" : ",\n") + frame;
  const auto dump = [](const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);  // a folder need not be UTF-8
  };
  return fmt::format(
      "{{\"schema\": \"racebeam-pins\", \"version\": 1,\n\"chip\": {},\n\"syncs\": {},\n"
      "\"faults\": {},\n\"frames\": [{}],\n\"total\": {}{}}}\n",
      dump(chip), dump(syncs), dump(broken), rows, dump(total),
      against.empty() ? "" : ",\n\"against\": " + against);
}

std::string PinsReport::table_header() const {
  const Raster& raster = found_.raster;
  std::string text = fmt::format(
      "{}: {}, drawn as {}x{}, {:.2f} frames a second at {} Hz, clocks per pixel {:.4g}\n"
      "hsync {}, every {} clocks; vsync {}, every {} clocks\n",
      project_.top, found_.mode, raster.columns, raster.rows, found_.frames_per_second(),
      std::llround(found_.clock_hz), found_.clocks_per_pixel, polarity(raster.hsync_pulse),
      raster.line_clocks(), polarity(raster.vsync_pulse), raster.frame_clocks());
  if (const int late = found_.picture_late; late != 0)
    text += fmt::format("the picture comes {} {} for its hsync; it was moved back\n",
                        counted(std::abs(late), "clock"), late > 0 ? "too late" : "too early");
  return text + fmt::format(Row, "frame", "colours", "uo_out toggles") +
         (crc_ ? "  image    pins\n" : "\n");
}

std::string PinsReport::table_row(int frame, const TtBench::Frame& seen) const {
  return fmt::format(Row, frame, seen.stats.colours.count(), uo_toggles(seen.stats)) +
         (crc_ ? fmt::format("  {:08x} {:08x}\n", seen.picture.image_crc, seen.picture.pins_crc)
               : "\n");
}

std::string PinsReport::table_pins() const {
  const auto percent = [&](std::uint64_t clocks) {
    return fmt::format("{:.2f} %", 100 * share(clocks, total_.clocks));
  };
  std::string text = fmt::format(PinRow, "pin", "", "toggles", "high", "enabled");
  for (int pin = 0; pin < PinStats::Pins; ++pin)
    text += fmt::format(PinRow, pin_name(pin), pin < 8 ? VgaPinNames[pin] : "", total_.toggles[pin],
                        percent(total_.high[pin]), percent(total_.enabled[pin]));
  return text;
}

}  // namespace racebeam
