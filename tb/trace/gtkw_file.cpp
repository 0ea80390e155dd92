// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/trace/gtkw_file.h"

#include <filesystem>
#include <map>
#include <vector>

namespace racebeam {

namespace fs = std::filesystem;

namespace {

// Flags of a trace in GTKWave 3.3, hexadecimal.
constexpr const char *Hex = "@22", *Decimal = "@24", *Signed = "@420", *Binary = "@28",
                     *Words = "@820";
constexpr const char *OpenGroup = "@800200", *EndOpenGroup = "@1000200", *FoldedGroup = "@c00200",
                     *EndFoldedGroup = "@1401200";
enum Colour { Normal = 0, Orange = 2, Yellow = 3, Green = 4, Blue = 5 };

/// Whether a name without its suffix is one of two's complement (see the ports' comments).
bool is_signed(const std::string& name) {
  for (const char* stem : {"dr1", "dr2", "delta", "corner", "position", "start_", "velocity",
                           "nav_position", "ddr_", "head_len", "h_pos", "v_pos", "x2"})
    if (name.rfind(stem, 0) == 0) return name.rfind("start_room", 0) != 0;
  return name == "line" || name == "pixel" || name == "y" || name == "y_i" || name == "y_o";
}

/// Numbers that mean a place, a length or a count.
bool is_count(const std::string& name) {
  for (const char* stem :
       {"i1", "i2", "idx", "lo_", "hi_", "len", "tail_len", "fill", "sp", "sd", "top_i2", "frame",
        "clock", "depth", "angle", "half_size", "step_size", "tail_ptr"})
    if (name.rfind(stem, 0) == 0) return true;
  return false;
}

const char* format_of(const std::string& name, int bits) {
  if (bits == 0) return Words;
  if (bits == 1) return Binary;
  return is_signed(name) ? Signed : is_count(name) ? Decimal : Hex;
}

Colour colour_of(const std::string& name, int bits) {
  const auto ends = [&](const char* end) {
    const std::string text = end;
    return name.size() >= text.size() &&
           name.compare(name.size() - text.size(), text.size(), text) == 0;
  };
  if (bits == 0) return Yellow;
  if (ends("_i") || ends("_ni")) return Blue;
  if (ends("_o") || ends("_no")) return Orange;
  return name.find("_q") != std::string::npos ? Green : Normal;
}

void add_group(std::string& text, const std::string& scope, bool open,
               const std::vector<const VcdWriter::Name*>& names, const VcdWriter& vcd) {
  text += std::string(open ? OpenGroup : FoldedGroup) + "\n-" + scope + "\n";
  for (const auto* name : names) {
    const int bits = vcd.bits(name->signal);
    text += std::string(format_of(name->name, bits)) + "\n[color] " +
            std::to_string(colour_of(name->name, bits)) + "\n" + name->path() +
            (bits > 1 ? "[" + std::to_string(bits - 1) + ":0]" : "") + "\n";
  }
  text += std::string(open ? EndOpenGroup : EndFoldedGroup) + "\n-" + scope + "\n";
}

}  // namespace

std::string gtkw_path(const std::string& dump) {
  return fs::path(dump).replace_extension(".gtkw").string();
}

std::string gtkw_text(const std::string& dump, const VcdWriter& vcd) {
  std::map<std::string, std::vector<const VcdWriter::Name*>> groups;
  for (const auto& name : vcd.names()) groups[name.scope].push_back(&name);
  std::string text = "[*] racebeam\n[dumpfile] \"" + fs::absolute(dump).string() +
                     "\"\n[timestart] 0\n[sst_expanded] 1\n";
  add_group(text, "beam", true, groups["beam"], vcd);
  for (const auto& [scope, names] : groups)
    if (scope != "beam") add_group(text, scope, scope.rfind("tlm.", 0) == 0, names, vcd);
  return text;
}

}  // namespace racebeam
