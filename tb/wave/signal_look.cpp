// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/wave/signal_look.h"

#include <fmt/format.h>

#include <cstdint>

namespace racebeam {

namespace {

constexpr int WidestNumber = 64;

/// Whether a name without its suffix is one of two's complement (see the ports' comments).
bool is_signed(const std::string& name) {
  for (const char* stem :
       {"dr1", "dr2", "delta", "corner", "position", "start_x", "start_y", "start_z", "velocity",
        "nav_position", "ddr_", "head_len", "h_pos", "v_pos", "x2"})
    if (name.rfind(stem, 0) == 0) return true;
  return name == "line" || name == "pixel" || name == "y" || name == "y_i" || name == "y_o";
}

/// Numbers that mean a place, a length or a count.
bool is_count(const std::string& name) {
  for (const char* stem :
       {"i1",       "i2",       "idx",        "lo_",       "hi_",       "len",
        "tail_len", "fill",     "sp",         "sd",        "top_i2",    "frame",
        "clock",    "depth",    "angle",      "half_size", "step_size", "tail_ptr",
        "room",     "nav_room", "start_room", "neighbour"})
    if (name.rfind(stem, 0) == 0) return true;
  return false;
}

bool ends(const std::string& name, const std::string& end) {
  return name.size() >= end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
}

}  // namespace

NumberFormat format_of(const std::string& name, int bits) {
  if (bits == 0) return NumberFormat::Words;
  if (bits == 1) return NumberFormat::Bit;
  if (bits > WidestNumber) return NumberFormat::Hex;
  return is_signed(name)  ? NumberFormat::Signed
         : is_count(name) ? NumberFormat::Decimal
                          : NumberFormat::Hex;
}

SignalRole role_of(const std::string& name, int bits) {
  if (bits == 0) return SignalRole::Words;
  if (ends(name, "_i") || ends(name, "_ni")) return SignalRole::Input;
  if (ends(name, "_o") || ends(name, "_no")) return SignalRole::Output;
  return name.find("_q") != std::string::npos ? SignalRole::Register : SignalRole::Wire;
}

std::string formatted(const std::string& digits, NumberFormat format, int bits) {
  if (format == NumberFormat::Words || digits.empty()) return digits;
  if (digits.find_first_not_of("01") != std::string::npos) return "x";
  std::uint64_t value = 0;
  for (const char digit : digits) value = value << 1 | (digit == '1');
  if (format == NumberFormat::Signed) {
    const int unused = WidestNumber - bits;
    return fmt::format("{}", static_cast<std::int64_t>(value << unused) >> unused);
  }
  if (format != NumberFormat::Hex) return fmt::format("{}", value);
  std::string text;
  const std::string all(static_cast<std::size_t>(bits) - digits.size(), '0');
  const std::string padded = std::string((4 - bits % 4) % 4, '0') + all + digits;
  for (std::size_t at = 0; at < padded.size(); at += 4)
    text += "0123456789abcdef"[std::stoi(padded.substr(at, 4), nullptr, 2)];
  return bits < 4 ? text : "0x" + text;
}

}  // namespace racebeam
