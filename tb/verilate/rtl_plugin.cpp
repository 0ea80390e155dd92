// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/rtl_plugin.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <optional>
#include <set>
#include <vector>

#include "sc/swap/rtl_island.h"
#include "sc/swap/rtl_library.h"
#include "tb/verilate/cache_folder.h"
#include "tb/verilate/clock_wrapper.h"
#include "tb/verilate/comb_paths.h"
#include "tb/verilate/direct_steps.h"
#include "tb/verilate/elaborated.h"
#include "tb/verilate/making_line.h"
#include "tb/verilate/plugin_compiler.h"
#include "tb/verilate/rtl_syntax.h"
#include "tb/verilate/verilator.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

constexpr int MostAttempts = 5;  // while sources change
constexpr int MostBits = 64;     // of a wire of a chip

/// A name that is the same in C++.
bool is_plain(const std::string& name) {
  return name.find("__") == std::string::npos &&
         std::all_of(name.begin(), name.end(),
                     [](unsigned char c) { return std::isalnum(c) || c == '_'; });
}

std::string c_string(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (c == '\n') out += "\\n\"\n\"";
    else out += c;
  }
  return out + "\"";
}

std::string text_of(const RtlSyntax::Place& place) {
  return place.file + ":" + std::to_string(place.line) + " " + place.name;
}

/// "FILE:LINE NAME" as the RTL has it, of a signal that may be a port of the wrapper.
std::string of_rtl(const std::string& signal, const std::string& wrapper, const RtlSyntax& syntax) {
  if (signal.rfind(wrapper + ":", 0) != 0) return signal;
  const std::string name = signal.substr(signal.find_last_of(" .") + 1);
  for (const RtlSyntax::Port& port : syntax.ports)
    if (port.name == name) return text_of(port.place);
  return text_of(syntax.top);
}

/// KIND FILE:LINE NAME, one a line.
std::string remarks(const RtlSyntax& syntax, const std::vector<std::string>& circular,
                    const CombGroups& groups) {
  std::string text;
  const auto add = [&](const std::string& kind, const RtlSyntax::Place& place) {
    text += kind + " " + text_of(place) + "\n";
  };
  add("top", syntax.top);
  for (const std::string& file : syntax.files) add("file", {file, 1, "-"});
  for (const auto& place : syntax.falling) add("falling", place);
  for (const auto& place : syntax.loops) add("loop", place);
  for (const auto& place : syntax.calls) add("call", place);
  for (const RtlSyntax::Port& port : syntax.ports)
    if (port.direction == "input" && port.name != syntax.clock && groups.count(port.name) == 0)
      add("quiet", port.place);
  for (const std::string& signal : circular) text += "circular " + signal + "\n";
  const std::string inside = std::string(Wrapper) + "." + Wrapped + ".";
  for (std::size_t at = 0; (at = text.find(inside, at)) != std::string::npos;)
    text.replace(at, inside.size(), syntax.top.name + ".");
  return text;
}

/// The bit of an input that follows a wire: not the clock, and of an island nothing that a unit has
/// apart.
std::optional<int> bit_when_moved(const RtlSyntax::Port& port, const RtlSyntax& syntax,
                                  const CombGroups& groups, const CombGroups& taken) {
  const auto begins = [&port](const std::string& start) { return port.name.rfind(start, 0) == 0; };
  const bool island = syntax.top.name == IslandTop;
  if (port.direction != "input" || port.bits > MostBits || port.name == syntax.clock ||
      port.name == Tick || begins(Take) || (island && (begins(OwnTick) || begins(OwnPins))))
    return {};
  if (island && begins(IslandGroup)) return std::stoi(port.name.substr(std::strlen(IslandGroup)));
  if (groups.count(port.name) == 0 || (island && begins(IslandLate))) return RtlQuiet;
  const auto group = taken.find(port.name);
  return group == taken.end() ? 0 : group->second;
}

/// What the glue is told of the RTL: all but texts, so that equal RTL elsewhere compiles to the
/// same.
std::string facts(const RtlSources& sources, const RtlSyntax& syntax, const CombGroups& groups,
                  const CombGroups& taken) {
  const bool wrapped = is_wrapped(sources, syntax);
  bool has_tick = syntax.rising_only;  // or is an island, with its own
  std::set<std::string> takes, own_ticks;
  for (const auto& [name, group] : taken) takes.insert(Take + std::to_string(group));
  std::string text = "#define RTL_PORTS", quiet = "#define RTL_QUIETS";
  for (const RtlSyntax::Port& port : syntax.ports) {
    if (!is_plain(port.name)) continue;
    const bool ticks = syntax.rising_only && port.name == syntax.clock;
    has_tick |= port.name == Tick;
    if (port.name.rfind(Take, 0) == 0) takes.insert(port.name);
    if (syntax.top.name == IslandTop && port.name.rfind(OwnTick, 0) == 0)
      own_ticks.insert(port.name);
    const auto bit = bit_when_moved(port, syntax, groups, taken);
    if (bit == RtlQuiet) quiet += fmt::format(" RTL_PORT({})", port.name);
    const std::string place =
        !bit ? "nullptr"
             : fmt::format("&{}.{}", bit == RtlQuiet ? "waiting" : "top_module", port.name);
    text += fmt::format(" RTL_PORT({}, {}, {}, {:d}, {}, {}U)", port.name, ticks ? Tick : port.name,
                        port.bits, port.direction == "input", place, bit ? 1U << *bit : 0);
  }
  text += "\n" + quiet + "\n";
  if (has_tick) text += std::string("#define RTL_TICK ") + Tick + "\n";
  if (has_tick && !syntax.state_elsewhere)
    text +=
        fmt::format("#define RTL_SEEN {}__DOT__{}\n", wrapped ? Wrapper : sources.top, TickSeen);
  else if (!syntax.clock.empty()) text += "#define RTL_CLOCK " + syntax.clock + "\n";
  text += "#define RTL_OWN_TICKS";
  for (const std::string& tick : own_ticks)
    text += fmt::format(" RTL_OWN_TICK({0}, {1}__DOT__{0}_seen)", tick, IslandTop);
  text += "\n";
  if (!takes.empty()) text += "#define RTL_TAKE";
  for (const std::string& take : takes) text += " RTL_GROUP(" + take + ")";
  text += "\n";
  if (!sources.doors.empty())
    text += std::string("#define RTL_KNOCK ") + Knock + "\n#define RTL_DOORS";
  for (std::size_t n = 0; n < sources.doors.size(); ++n)
    text += fmt::format(" RTL_DOOR({}, {}{})", c_string(sources.doors[n]), Door, n);
  text += "\n";
  if (sources.signals)
    text += "#define RTL_SIGNALS\n#define RTL_SCOPE " +
            (wrapped ? c_string(std::string(Wrapper) + "." + Wrapped) : "rtl_unit") + "\n";
  return text;
}

/// Settings that the RTL's syntax does not tell: texts, such as the name of a table's file, and
/// what gates were made with.
std::vector<std::string> settings_beside(const RtlSources& sources) {
  std::vector<std::string> settings = sources.made_with;
  std::copy_if(sources.parameters.begin(), sources.parameters.end(), std::back_inserter(settings),
               [](const std::string& one) { return one.find('"') != std::string::npos; });
  return settings;
}

std::string texts(const RtlSyntax& syntax, const std::vector<std::string>& settings,
                  const std::vector<std::string>& circular, const CombGroups& groups) {
  std::string parameters;
  for (const std::string& setting : settings) parameters += setting + " ";
  for (const RtlSyntax::Parameter& parameter : syntax.parameters)
    if (!parameter.value.empty()) parameters += parameter.name + "=" + parameter.value + " ";
  return "extern const char* const rtl_unit = " + c_string(syntax.top.name) +
         ";\nextern const char* const rtl_parameters = " + c_string(parameters) +
         ";\nextern const char* const rtl_remarks = " +
         c_string(remarks(syntax, circular, groups)) + ";\n";
}

/// "stacks (mine.sv and 1 more)".
std::string named(const RtlSources& sources) {
  if (sources.files.empty()) return sources.top;
  const std::size_t more = sources.files.size() - 1;
  return sources.top + " (" + fs::path(sources.files[0]).filename().string() +
         (more > 0 ? " and " + std::to_string(more) + " more)" : ")");
}

/// What the glue is told to call.
std::string text_of(const DirectSteps& steps) {
  std::string text = "#define RTL_INPUT_STEPS";
  for (const std::string& function : steps.inputs) text += fmt::format(" RTL_STEP({})", function);
  std::string before, calls;
  std::set<std::string> compared;
  for (const DirectStep& step : steps.registers) {
    std::string needed = step.at_tick && step.always ? "true" : "false";
    for (const std::string& function : step.called) needed += " || called_" + function;
    for (const std::string& member : step.changed) {
      needed += fmt::format(" || root->{0} != {0}_before", member);
      if (compared.insert(member).second) before += fmt::format(" RTL_BEFORE({})", member);
    }
    unsigned groups = 0;
    for (const int group : step.groups) groups |= 1U << group;
    calls += fmt::format(" RTL_STEP({}, {}, {}U)", step.function, needed, groups);
  }
  return text + "\n#define RTL_STEPS" + before + calls + "\n";
}

/// A source was saved while it was read.
struct Changed {};

/// Of the gates of a whole chip with all signals, 36 MB, the compiler makes nothing in half an hour
/// unless they are in small functions.
constexpr std::uintmax_t MostInLarge = 10'000'000;  // bytes

std::uintmax_t class_bytes(const WorkFolder& work) {
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::directory_iterator(work.path()))
    if (entry.path().extension() == ".cpp") bytes += entry.file_size();
  return bytes;
}

void remove_classes(const WorkFolder& work) {
  std::vector<fs::path> classes;
  for (const auto& entry : fs::directory_iterator(work.path()))
    if (entry.path().extension() == ".cpp") classes.push_back(entry.path());
  for (const fs::path& file : classes) fs::remove(file);
}

/// Whoever looks or writes inside has all inputs at once.
CombGroups groups_of(const RtlSources& sources, const RtlSyntax& syntax) {
  const bool looked_into =
      syntax.clock.empty() || sources.signals || sources.coverage || !sources.doors.empty();
  return looked_into ? one_group(syntax) : comb_groups(sources);
}

/// The plug-in of what `elaborated` has named `content`. Throws Changed if that is not what was
/// read.
void make(RtlSources sources, const std::string& content, const std::string& out) {
  const RtlSources whole = sources;
  const RtlSyntax syntax = read_rtl_syntax(sources);
  const MakingLine line("verilating " + named(sources));
  const WorkFolder work;
  const CombGroups groups = groups_of(whole, syntax);
  const CombGroups taken = taken_inputs(sources, syntax, groups);
  std::string known = facts(sources, syntax, groups, taken);
  if (is_wrapped(sources, syntax)) {
    work.write("wrapper.sv", clock_wrapper(sources, syntax, taken));
    sources.files.push_back(work.file("wrapper.sv"));
    sources.top = Wrapper;
    sources.parameters.clear();
  }
  auto circular = circular_signals(write_rtl_classes(sources, work.path(), false, line.tick()));
  for (std::string& signal : circular) signal = of_rtl(signal, work.file("wrapper.sv"), syntax);
  if (elaborated(whole).content != content) throw Changed();
  if (class_bytes(work) > MostInLarge) {
    remove_classes(work);
    write_rtl_classes(sources, work.path(), true, line.tick());
  }
  if (const auto steps = direct_steps(work.path())) known += text_of(*steps);
  compile_plugin(work, known, texts(syntax, settings_beside(whole), circular, groups),
                 sources.coverage, line.tick(), out);
}

}  // namespace

std::string rtl_plugin(const RtlSources& sources) {
  for (int attempt = 0; attempt < MostAttempts; ++attempt) {
    const std::string content = elaborated(sources).content;
    std::vector<std::string> parts = {content, sources.kind == RtlSources::Chip ? "chip" : "unit",
                                      !sources.signals      ? "ports"
                                      : sources.marked_only ? "marked signals"
                                                            : "signals",
                                      sources.coverage ? coverage_key() : "", compile_key()};
    const std::vector<std::string> beside = settings_beside(sources);
    parts.insert(parts.end(), beside.begin(), beside.end());
    parts.insert(parts.end(), sources.doors.begin(), sources.doors.end());
    const std::string key = content_key(parts);
    try {
      return cached(key + ".so", [&](const std::string& out) { make(sources, content, out); });
    } catch (const Changed&) {  // again, with what is there now
    }
  }
  throw RtlError("the files of " + sources.top + " change while they are verilated; try again");
}

}  // namespace racebeam
