// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/verilator.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "sc/swap/rtl_library.h"
#include "tb/base/errors.h"
#include "tb/base/project_folder.h"
#include "tb/base/text_pattern.h"
#include "tb/verilate/run_tool.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

std::string absolute(const std::string& path) {
  return fs::absolute(path).lexically_normal().string();
}

std::string trimmed(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

bool brings(const RtlSources& sources, const fs::path& package) {
  return std::any_of(
      sources.files.begin(), sources.files.end(),
      [&package](const std::string& file) { return fs::path(file).stem() == package.stem(); });
}

/// The project's packages, *_pkg.sv, but for those that the sources bring.
std::vector<std::string> missing_packages(const RtlSources& sources) {
  static const TextPattern Package(".*_pkg\\.sv");
  std::vector<std::string> packages;
  for (const std::string& folder : rtl_folders())
    for (const auto& entry : fs::directory_iterator(folder))
      if (Package.matches(entry.path().filename().string()) && !brings(sources, entry.path()))
        packages.push_back(absolute(entry.path().string()));
  std::sort(packages.begin(), packages.end());
  return packages;
}

/// Adds the names of warnings that later versions know to Verilator's options, if it complained of
/// such in comments of the source.
bool allow_unknown_lint(std::vector<std::string>& words, const std::string& messages) {
  static const TextPattern Unknown("Unknown verilator lint message code: '([A-Za-z0-9_]+)'");
  const std::size_t before = words.size();
  for (const TextPattern::Groups& found : Unknown.all(messages)) {
    const std::string word = "-Wfuture-" + found[1];
    if (std::find(words.begin(), words.end(), word) == words.end()) words.push_back(word);
  }
  return words.size() > before;
}

std::string run_verilator(const RtlSources& sources, std::vector<std::string> words,
                          const std::function<void()>& tick) {
  words.insert(words.begin(), "verilator");
  for (const char* common :
       {"--no-timing", "-Wno-fatal", "-Wno-lint", "-Wno-style", "-Wfuture-WIDTHTRUNC",
        "-Wfuture-WIDTHEXPAND", "-Werror-USERERROR", "-Werror-USERFATAL"})
    words.emplace_back(common);
  for (const std::string& word : source_words(sources)) words.push_back(word);
  ToolResult result = run_tool({words, "", {}, tick});
  while (!result.good && allow_unknown_lint(words, result.said))
    result = run_tool({words, "", {}, tick});
  if (result.good) return result.said;
  std::string files;
  for (const std::string& file : sources.files) files += (files.empty() ? "" : ", ") + file;
  throw RtlError("the RTL of " + sources.top + " (" + files + ") cannot be verilated:\n" +
                 trimmed(result.said));
}

}  // namespace

const std::string& verilator_version() {
  static const std::string version = [] {
    if (!has_tool("verilator"))
      throw MissingTool("verilator is not installed; install the package `verilator`");
    const ToolResult result = run_tool({{"verilator", "--version"}, "", {}, {}});
    if (!result.good) throw MissingTool("verilator does not run: " + trimmed(result.said));
    return trimmed(result.said);
  }();
  return version;
}

std::string verilator_runtime() {
  static const std::string root =
      trimmed(run_tool({{"verilator", "--getenv", "VERILATOR_ROOT"}, "", {}, {}}).said);
  return root + "/include";
}

std::vector<std::string> searched_folders(const RtlSources& sources) {
  std::vector<std::string> folders;
  const auto add = [&](const std::string& folder) {
    if (std::find(folders.begin(), folders.end(), folder) == folders.end())
      folders.push_back(folder);
  };
  for (const std::string& folder : sources.include_folders) add(absolute(folder));
  for (const std::string& file : sources.files) add(fs::path(absolute(file)).parent_path());
  for (const std::string& library : sources.libraries)
    if (fs::is_directory(library)) add(absolute(library));
  if (sources.kind == RtlSources::Unit)
    for (const std::string& folder : rtl_folders()) add(absolute(folder));
  return folders;
}

std::vector<std::string> source_words(const RtlSources& sources) {
  std::vector<std::string> words = {"--relative-includes"};
  for (const std::string& folder : searched_folders(sources)) words.push_back("-I" + folder);
  for (const std::string& library : sources.libraries)
    if (!fs::is_directory(library)) words.insert(words.end(), {"-v", absolute(library)});
  for (const std::string& define : sources.defines) words.push_back("-D" + define);
  for (const std::string& parameter : sources.parameters) words.push_back("-G" + parameter);
  if (sources.kind == RtlSources::Unit)
    for (const std::string& package : missing_packages(sources)) words.push_back(package);
  for (const std::string& file : sources.files) words.push_back(absolute(file));
  return words;
}

void write_rtl_xml(const RtlSources& sources, const std::string& work, const std::string& xml) {
  run_verilator(
      sources,
      {"--xml-only", "--xml-output", xml, "--assert", "--Mdir", work, "--top-module", sources.top},
      {});
}

std::string write_rtl_classes(const RtlSources& sources, const std::string& work, bool split,
                              const std::function<void()>& tick) {
  // Verilator 5.006 gets netlists wrong in the two optimisations that are turned off here.
  std::vector<std::string> words = {"--cc",         "-O3",        "-fno-const-bit-op-tree",
                                    "-fno-dfg",     "--x-assign", "unique",
                                    "--x-initial",  "unique",     "--assert",
                                    "--top-module", sources.top,  "--prefix",
                                    "Vrtl",         "--Mdir",     work};
  if (sources.signals && !sources.marked_only) words.emplace_back("--public-flat-rw");
  // Split blocks count a branch by what its condition is worth behind it.
  if (sources.coverage)
    words.insert(words.end(), {"--coverage-line", "--coverage-toggle", "-fno-split"});
  if (split) words.insert(words.end(), {"--output-split", "20000", "--output-split-cfuncs", "500"});
  return run_verilator(sources, words, tick);
}

std::vector<std::string> circular_signals(const std::string& messages) {
  static const TextPattern Message(
      "%Warning-UNOPTFLAT: (.*):([0-9]+):[0-9]+: .*Circular combinational logic: '([^']*)'");
  std::vector<std::string> signals;
  std::istringstream lines(messages);
  for (std::string line; std::getline(lines, line);)
    if (const TextPattern::Groups found = Message.search(line); !found.empty())
      signals.push_back(found[1] + ":" + found[2] + " " + found[3]);
  return signals;
}

}  // namespace racebeam
