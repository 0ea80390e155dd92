// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/wave/gtkw_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <system_error>
#include <vector>

#include "tb/wave/signal_look.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

constexpr const char* Title = "[*] racebeam";  // GTKWave writes "[*] GTKWave Analyzer v3..."

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

/// A colour of GTKWave: 0 normal, 2 orange, 3 yellow, 4 green, 7 violet.
int colour_of(SignalRole role) {
  switch (role) {
    case SignalRole::Words: return 3;
    case SignalRole::Input: return 7;
    case SignalRole::Output: return 2;
    case SignalRole::Register: return 4;
    default: return 0;
  }
}

/// What shows the tracer at work, from its state to the beam.
constexpr const char* Overview[] = {"chip.u_subdivider.state_q_name",
                                    "chip.u_subdivider.i1_q",
                                    "chip.u_subdivider.i2_q",
                                    "chip.u_subdivider.idx2_q",
                                    "chip.restart",
                                    "chip.sp",
                                    "chip.room",
                                    "chip.emit",
                                    "chip.len_m1",
                                    "chip.value",
                                    "chip.ack",
                                    "chip.fill",
                                    "chip.starving",
                                    "chip.consume",
                                    "chip.display",
                                    "chip.uo_o"};

constexpr std::size_t FewSignals = 80;

using Names = std::vector<const VcdWriter::Name*>;

/// `alias`: what is shown instead of the name.
void add_signal(std::string& text, const VcdWriter::Name& name, const VcdWriter& vcd, int colour,
                const std::string& alias = {}) {
  const int bits = vcd.bits(name.signal);
  text += fmt::format("{}\n[color] {}\n{}{}{}\n", flags_of(format_of(name.name, bits)), colour,
                      alias.empty() ? "" : "+{" + alias + "} ", name.path(),
                      bits > 1 ? fmt::format("[{}:0]", bits - 1) : "");
}

void add_group(std::string& text, const std::string& title, bool open, const Names& names,
               const VcdWriter& vcd) {
  text += std::string(open ? OpenGroup : FoldedGroup) + "\n-" + title + "\n";
  for (const auto* name : names)
    add_signal(text, *name, vcd, colour_of(role_of(name->name, vcd.bits(name->signal))));
  text += std::string(open ? EndOpenGroup : EndFoldedGroup) + "\n-" + title + "\n";
}

/// Both sides of the port, one below the other, and what its unit was given.
void add_difference(std::string& text, const DifferingPort& port, const VcdWriter& vcd) {
  constexpr int Red = 1;
  const std::string title = "differs: " + port.scope + "." + port.name;
  text += std::string(OpenGroup) + "\n-" + title + "\n";
  for (const auto& [side, scope] : {std::pair{"model", port.scope}, {"RTL", port.scope + ".rtl"}})
    for (const auto& name : vcd.names())
      if (name.scope == scope && name.name == port.name)
        add_signal(text, name, vcd, Red, fmt::format("{} {}", side, port.name));
  text += std::string(EndOpenGroup) + "\n-" + title + "\n";
  Names inputs;
  for (const auto& name : vcd.names())
    if (name.scope == port.scope && role_of(name.name, vcd.bits(name.signal)) == SignalRole::Input)
      inputs.push_back(&name);
  add_group(text, "inputs of " + port.scope, true, inputs, vcd);
}

Names overview(const VcdWriter& vcd) {
  Names names;
  for (const char* path : Overview)
    for (const auto& name : vcd.names())
      if (name.path() == path) names.push_back(&name);
  return names;
}

// All of the window is seen; around a marker a unit of time is wide enough for the number in it.
std::string view(const GtkwWindow& window) {
  constexpr double Width = 1400, Tree = 40, Signals = 330, Waves = Width - Tree - Signals - 40;
  constexpr double Narrowest = 46, Widest = 80, UnitOfZoom = 200;  // pixels
  const double clocks =
      static_cast<double>(window.end - window.begin) / static_cast<double>(window.unit);
  const double pixels =
      std::clamp(Waves / std::max(clocks, 1.), window.marker ? Narrowest : 0., Widest);
  const std::uint64_t half = static_cast<std::uint64_t>(Waves / pixels / 2) * window.unit;
  std::uint64_t start = window.begin;
  if (window.marker && *window.marker > window.begin + half) start = *window.marker - half;
  std::string named;
  for (char marker = 'a'; marker <= 'z'; ++marker) named += " -1";
  return fmt::format(
      "[timestart] {}\n[size] {} 800\n*{:.6f} {}{}\n[sst_width] {}\n"
      "[signals_width] {}\n[sst_expanded] 0\n",
      start, Width, -std::log2(static_cast<double>(window.unit) * UnitOfZoom / pixels),
      window.marker ? std::to_string(*window.marker) : "-1", named, Tree, Signals);
}

}  // namespace

std::string gtkw_path(const std::string& dump) {
  return fs::path(dump).replace_extension(".gtkw").string();
}

bool is_foreign_gtkw(const std::string& path) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return false;
  std::ifstream in(path);
  std::string first;
  std::getline(in, first);
  return first != Title;
}

std::string gtkw_text(const std::string& dump, const VcdWriter& vcd, const GtkwWindow& window) {
  std::map<std::string, Names> groups;
  for (const auto& name : vcd.names()) groups[name.scope].push_back(&name);
  std::string text = std::string(Title) + "\n[dumpfile] \"" + fs::path(dump).filename().string() +
                     "\"\n[savefile] \"" + fs::path(gtkw_path(dump)).filename().string() + "\"\n" +
                     view(window);
  if (window.differs) add_difference(text, *window.differs, vcd);
  add_group(text, "beam", true, groups["beam"], vcd);
  const bool few = vcd.names().size() <= FewSignals;
  if (const Names tracer = overview(vcd); !few && !tracer.empty())
    add_group(text, "overview", true, tracer, vcd);
  for (const auto& [scope, names] : groups)
    if (scope != "beam") add_group(text, scope, few, names, vcd);
  return text;
}

}  // namespace racebeam
