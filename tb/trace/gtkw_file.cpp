// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/trace/gtkw_file.h"

#include <filesystem>
#include <map>
#include <vector>

#include "tb/trace/signal_look.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

// Flags of a trace in GTKWave 3.3, hexadecimal.
constexpr const char *OpenGroup = "@800200", *EndOpenGroup = "@1000200", *FoldedGroup = "@c00200",
                     *EndFoldedGroup = "@1401200";

const char* flags_of(NumberFormat format) {
  switch (format) {
    case NumberFormat::Words: return "@820";
    case NumberFormat::Bit: return "@28";
    case NumberFormat::Signed: return "@420";
    case NumberFormat::Decimal: return "@24";
    default: return "@22";
  }
}

/// A colour of GTKWave: 0 normal, 2 orange, 3 yellow, 4 green, 5 blue.
int colour_of(SignalRole role) {
  switch (role) {
    case SignalRole::Words: return 3;
    case SignalRole::Input: return 5;
    case SignalRole::Output: return 2;
    case SignalRole::Register: return 4;
    default: return 0;
  }
}

void add_group(std::string& text, const std::string& scope, bool open,
               const std::vector<const VcdWriter::Name*>& names, const VcdWriter& vcd) {
  text += std::string(open ? OpenGroup : FoldedGroup) + "\n-" + scope + "\n";
  for (const auto* name : names) {
    const int bits = vcd.bits(name->signal);
    text += std::string(flags_of(format_of(name->name, bits))) + "\n[color] " +
            std::to_string(colour_of(role_of(name->name, bits))) + "\n" + name->path() +
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
    if (scope != "beam") add_group(text, scope, false, names, vcd);
  return text;
}

}  // namespace racebeam
