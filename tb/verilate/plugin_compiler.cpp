// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/plugin_compiler.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "sc/swap/rtl_library.h"
#include "tb/base/errors.h"
#include "tb/base/project_folder.h"
#include "tb/verilate/run_tool.h"
#include "tb/verilate/verilator.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

/// Another one whenever the same sources shall become another plug-in.
constexpr const char* Recipe = "13";

/// -O3 compiles for half as long again and is no faster, -O1 13 % slower (the island of the whole
/// beam).
constexpr const char* Level = "-O2";

constexpr const char* OfVerilator = "verilator-";  ///< names in the cache of what no RTL changes

constexpr const char* RuntimeHeader = "rtl_runtime.h";
constexpr const char* CoverageGlue = "rtl_coverage.cc.in";

std::string swap_file(const std::string& name) { return project_folder() + "/sc/swap/" + name; }

std::string compiler() {
  const char* named = std::getenv("CXX");
  const std::string name = named && *named ? named : "c++";
  if (!has_tool(name) && !fs::exists(name))
    throw MissingTool("there is no C++ compiler '" + name + "'; install the package `g++`");
  return name;
}

/// Parsed headers are of use for this very one; another one ignores them.
std::string compiler_version() { return run_tool({{compiler(), "--version"}, "", {}, {}}).said; }

/// Runs the compiler in a work folder.
class Compiler {
 public:
  Compiler(const WorkFolder& work, const std::function<void()>& tick) : work_(work), tick_(tick) {}

  /// The run-time header as the compiler has parsed it comes before itself in the folder.
  void share_headers() const;
  /// The file `object` of a source text that begins with the run-time header.
  void compile(const std::string& text, const std::string& object) const;
  void link(const std::vector<std::string>& objects, const std::string& out) const;
  /// An object that is kept in the cache under a name that begins with `prefix`, by what it is made
  /// of beside the text.
  std::string cached_object(const std::string& prefix, const std::string& text,
                            std::vector<std::string> parts) const;

 private:
  void run(const std::vector<std::string>& words) const;
  /// Compiler and options.
  static std::vector<std::string> common_words();

  const WorkFolder& work_;
  const std::function<void()>& tick_;
};

void Compiler::run(const std::vector<std::string>& words) const {
  const ToolResult result = run_tool({words, work_.path(), {}, tick_});
  if (!result.good) throw RtlError("the verilated RTL cannot be compiled:\n" + result.said);
}

std::vector<std::string> Compiler::common_words() {
  const std::string runtime = verilator_runtime();
  return {compiler(),
          "-std=c++17",
          Level,
          "-fno-tree-vectorize",  // bytes that were just written are read as a vector, which waits
          "-pipe",
          "-fno-finite-loops",
          "-fPIC",
          "-fvisibility=hidden",
          "-fno-gnu-unique",
          "-w",
          "-I.",
          "-I" + project_folder(),
          "-I" + swap_file(""),
          "-isystem",
          runtime,
          "-isystem",
          runtime + "/vltstd"};
}

void Compiler::share_headers() const {
  const std::string name = OfVerilator + content_key({compiler_version(), compile_key()}) + ".gch";
  const std::string parsed = cached(name, [&](const std::string& out) {
    std::vector<std::string> words = common_words();
    words.insert(words.end(), {"-x", "c++-header", swap_file(RuntimeHeader), "-o", out});
    run(words);
  });
  fs::create_symlink(parsed, work_.file(std::string(RuntimeHeader) + ".gch"));
}

void Compiler::compile(const std::string& text, const std::string& object) const {
  work_.write("source.cc", text);
  std::vector<std::string> words = common_words();
  words.insert(words.end(), {"-include", RuntimeHeader, "-c", "source.cc", "-o", object});
  run(words);
}

std::string Compiler::cached_object(const std::string& prefix, const std::string& text,
                                    std::vector<std::string> parts) const {
  parts.insert(parts.end(), {text, compile_key()});
  return cached(prefix + content_key(parts) + ".o",
                [&](const std::string& out) { compile(text, out); });
}

void Compiler::link(const std::vector<std::string>& objects, const std::string& out) const {
  std::vector<std::string> words = {compiler(), "-shared", "-Wl,-Bsymbolic,-z,defs"};
  words.insert(words.end(), objects.begin(), objects.end());
  words.insert(words.end(), {"-o", out, "-lpthread"});
  run(words);
}

/// The files of a folder with an extension, by name.
std::vector<std::string> files_in(const std::string& folder, const std::string& extension) {
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == extension) files.push_back(entry.path().filename());
  std::sort(files.begin(), files.end());
  return files;
}

std::string included(const std::string& file) { return "#include \"" + file + "\"\n"; }

}  // namespace

std::string compile_key() {
  return content_key({Recipe, compiler(), verilator_version(),
                      file_key(swap_file("rtl_glue.cc.in")), file_key(swap_file("rtl_model.h")),
                      file_key(swap_file("rtl_power_up.h")), file_key(swap_file(RuntimeHeader))});
}

std::string coverage_key() {
  return content_key({"coverage unsplit", file_key(swap_file(CoverageGlue)),
                      file_key(swap_file("rtl_coverage.h"))});
}

void compile_plugin(const WorkFolder& work, const std::string& facts, const std::string& texts,
                    bool coverage, const std::function<void()>& tick, const std::string& out) {
  const Compiler cxx(work, tick);
  cxx.share_headers();
  std::string classes = facts;
  std::vector<std::string> contents;
  for (const std::string& file : files_in(work.path(), ".h"))
    contents.push_back(file_key(work.file(file)));
  for (const std::string& file : files_in(work.path(), ".cpp")) {
    contents.push_back(file_key(work.file(file)));
    classes += included(file);
  }
  cxx.compile(texts, "texts.o");
  std::string runtime = included("verilated.cpp") + included("verilated_threads.cpp");
  classes += included("sc/swap/rtl_glue.cc.in");
  if (coverage) {
    runtime += included("verilated_cov.cpp");
    classes += included(std::string("sc/swap/") + CoverageGlue);
    contents.push_back(coverage_key());
  }
  cxx.link({cxx.cached_object(OfVerilator, runtime, {}), cxx.cached_object("", classes, contents),
            "texts.o"},
           out);
}

}  // namespace racebeam
