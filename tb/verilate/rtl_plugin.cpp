// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/rtl_plugin.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "sc/swap/rtl_library.h"
#include "tb/base/errors.h"
#include "tb/base/project_folder.h"
#include "tb/verilate/cache_folder.h"
#include "tb/verilate/clock_wrapper.h"
#include "tb/verilate/elaborated.h"
#include "tb/verilate/making_line.h"
#include "tb/verilate/rtl_syntax.h"
#include "tb/verilate/run_tool.h"
#include "tb/verilate/verilator.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

/// Another one whenever the same sources shall become another plug-in.
constexpr const char* Recipe = "4";

constexpr int MostAttempts = 5;  // while sources change

void write(const std::string& path, const std::string& text) {
  std::ofstream out(path);
  out << text;
  out.close();
  if (!out) throw RtlError("cannot write " + path + "; is the disk full?");
}

std::string glue_file() { return project_folder() + "/sc/swap/rtl_glue.cc.in"; }
std::string runtime_header() { return project_folder() + "/sc/swap/rtl_runtime.h"; }

std::string compiler() {
  const char* named = std::getenv("CXX");
  const std::string name = named && *named ? named : "c++";
  if (!has_tool(name) && !fs::exists(name))
    throw MissingTool("there is no C++ compiler '" + name + "'; install the package `g++`");
  return name;
}

/// Compiles with the compiler and what remembers its results, and links.
class Compiler {
 public:
  Compiler(std::string folder, std::function<void()> tick)
      : folder_(std::move(folder)), tick_(std::move(tick)) {}

  void compile(const std::string& source, const std::string& object,
               const std::string& level = "-O3") const {
    const std::string runtime = verilator_runtime();
    std::vector<std::string> words = {compiler(), "-std=c++17", level, "-include",
                                      runtime_header()};
    words.insert(words.end(), {"-pipe", "-fno-finite-loops", "-fPIC", "-fvisibility=hidden",
                               "-fno-gnu-unique", "-w", "-I.", "-I" + project_folder()});
    words.insert(words.end(), {"-isystem", runtime, "-isystem", runtime + "/vltstd", "-c", source,
                               "-o", object});
    if (has_tool("ccache")) words.insert(words.begin(), "ccache");
    run(words);
  }
  void link(const std::vector<std::string>& objects, const std::string& out) const {
    std::vector<std::string> words = {compiler(), "-shared", "-Wl,-Bsymbolic,-z,defs"};
    words.insert(words.end(), objects.begin(), objects.end());
    words.insert(words.end(), {"-o", out, "-lpthread"});
    run(words);
  }

 private:
  void run(const std::vector<std::string>& words) const {
    const ToolResult result =
        run_tool({words,
                  folder_,
                  {"CCACHE_DIR=" + cache_folder() + "/ccache", "CCACHE_MAXSIZE=300M",
                   "CCACHE_BASEDIR=" + folder_, "CCACHE_NOHASHDIR=1"},
                  tick_});
    if (!result.good) throw RtlError("the verilated RTL cannot be compiled:\n" + result.said);
  }

  std::string folder_;
  std::function<void()> tick_;
};

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
std::string remarks(const RtlSyntax& syntax, const std::vector<std::string>& circular) {
  std::string text;
  const auto add = [&](const std::string& kind, const RtlSyntax::Place& place) {
    text += kind + " " + text_of(place) + "\n";
  };
  add("top", syntax.top);
  for (const std::string& file : syntax.files) add("file", {file, 1, "-"});
  for (const auto& place : syntax.falling) add("falling", place);
  for (const auto& place : syntax.loops) add("loop", place);
  for (const auto& place : syntax.calls) add("call", place);
  for (const std::string& signal : circular) text += "circular " + signal + "\n";
  const std::string inside = std::string(Wrapper) + "." + Wrapped + ".";
  for (std::size_t at = 0; (at = text.find(inside, at)) != std::string::npos;)
    text.replace(at, inside.size(), syntax.top.name + ".");
  return text;
}

/// What the glue is told of the RTL: all but texts, so that equal RTL elsewhere compiles to the
/// same.
std::string facts(const RtlSources& sources, const RtlSyntax& syntax) {
  const bool wrapped = is_wrapped(sources, syntax);
  std::string text = "#define RTL_PORTS";
  for (const RtlSyntax::Port& port : syntax.ports) {
    if (!is_plain(port.name)) continue;
    const bool ticks = syntax.rising_only && port.name == syntax.clock;
    text += " RTL_PORT(" + port.name + ", " + (ticks ? Tick : port.name) + ", " +
            std::to_string(port.bits) + ", " + (port.direction == "input" ? "1" : "0") + ")";
  }
  text += "\n";
  if (syntax.rising_only) text += std::string("#define RTL_TICK ") + Tick + "\n";
  else if (!syntax.clock.empty()) text += "#define RTL_CLOCK " + syntax.clock + "\n";
  if (sources.signals)
    text += "#define RTL_SIGNALS\n#define RTL_SCOPE " +
            (wrapped ? c_string(std::string(Wrapper) + "." + Wrapped) : "rtl_unit") + "\n";
  return text;
}

std::string texts(const RtlSyntax& syntax, const std::vector<std::string>& circular) {
  std::string parameters;
  for (const RtlSyntax::Parameter& parameter : syntax.parameters)
    if (!parameter.value.empty()) parameters += parameter.name + "=" + parameter.value + " ";
  return "extern const char* const rtl_unit = " + c_string(syntax.top.name) +
         ";\nextern const char* const rtl_parameters = " + c_string(parameters) +
         ";\nextern const char* const rtl_remarks = " + c_string(remarks(syntax, circular)) + ";\n";
}

/// Verilator's run time, compiled once for all plug-ins.
std::string runtime_object(const std::string& source, const MakingLine& line) {
  const std::string key =
      content_key({source, verilator_version(), compiler(), file_key(runtime_header())});
  return cached(key + ".o", [&](const std::string& out) {
    const WorkFolder work;
    Compiler(work.path(), line.tick()).compile(verilator_runtime() + "/" + source, out);
  });
}

/// A source was saved while it was read.
struct Changed {};

/// Names of the C++ files in a folder, and how large they are in sum.
struct Classes {
  explicit Classes(const std::string& folder) {
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path().extension() == ".cpp") {
        files.push_back(entry.path().filename());
        bytes += entry.file_size();
      }
    std::sort(files.begin(), files.end());
  }
  std::vector<std::string> files;
  std::uintmax_t bytes = 0;
};

/// Of the gates of a whole chip with all signals, 36 MB, the compiler makes nothing in half an hour
/// unless they are in small functions, and it is not asked to improve them much.
constexpr std::uintmax_t MostToImprove = 10'000'000;  // bytes

/// The plug-in of what `elaborated` has named `content`. Throws Changed if that is not what was
/// read.
void make(RtlSources sources, const std::string& content, const std::string& out) {
  const RtlSources whole = sources;
  const RtlSyntax syntax = read_rtl_syntax(sources);
  const MakingLine line(sources.top, sources.files);
  std::vector<std::string> objects = {runtime_object("verilated.cpp", line),
                                      runtime_object("verilated_threads.cpp", line)};
  const WorkFolder work;
  const std::string known = facts(sources, syntax);
  if (is_wrapped(sources, syntax)) {
    write(work.file("wrapper.sv"), clock_wrapper(sources, syntax));
    sources.files.push_back(work.file("wrapper.sv"));
    sources.top = Wrapper;
    sources.parameters.clear();
  }
  auto circular = circular_signals(write_rtl_classes(sources, work.path(), false, line.tick()));
  for (std::string& signal : circular) signal = of_rtl(signal, work.file("wrapper.sv"), syntax);
  if (elaborated(whole).content != content) throw Changed();
  const bool large = Classes(work.path()).bytes > MostToImprove;
  if (large) {
    for (const std::string& file : Classes(work.path()).files) fs::remove(work.file(file));
    write_rtl_classes(sources, work.path(), true, line.tick());
  }
  std::string all = known;
  for (const std::string& file : Classes(work.path()).files)
    all += "#include " + c_string(file) + "\n";
  all += "#include \"sc/swap/rtl_glue.cc.in\"\n";
  write(work.file("all.cc"), all);
  write(work.file("texts.cc"), texts(syntax, circular));
  const Compiler cxx(work.path(), line.tick());
  cxx.compile("all.cc", "all.o", large ? "-O1" : "-O3");
  cxx.compile("texts.cc", "texts.o");
  objects.insert(objects.end(), {"all.o", "texts.o"});
  cxx.link(objects, out);
}

}  // namespace

std::string rtl_plugin(const RtlSources& sources) {
  for (int attempt = 0; attempt < MostAttempts; ++attempt) {
    const std::string content = elaborated(sources).content;
    const std::string key = content_key(
        {Recipe, content, sources.kind == RtlSources::Chip ? "chip" : "unit",
         sources.signals ? "signals" : "ports", compiler(), file_key(glue_file()),
         file_key(project_folder() + "/sc/swap/rtl_model.h"), file_key(runtime_header())});
    try {
      return cached(key + ".so", [&](const std::string& out) { make(sources, content, out); });
    } catch (const Changed&) {  // again, with what is there now
    }
  }
  throw RtlError("the files of " + sources.top + " change while they are verilated; try again");
}

}  // namespace racebeam
