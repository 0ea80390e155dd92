// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/tt/tt_plugin.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "sc/swap/rtl_library.h"
#include "tb/base/errors.h"
#include "tb/base/output_file.h"
#include "tb/tt/sky130_cells.h"
#include "tb/verilate/cache_folder.h"
#include "tb/verilate/rtl_plugin.h"
#include "tb/verilate/rtl_syntax.h"
#include "tb/verilate/rtl_warnings.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

/// The file of the cells, in the cache.
std::string cells_file() {
  const std::string text = sky130_library();
  return cached("sky130_" + content_key({text}) + ".v",
                [&](const std::string& path) { write_text(path, text); });
}

RtlSources sources_of(const TtProject& project) {
  RtlSources sources;
  sources.top = project.top;
  sources.files = project.sources;
  sources.include_folders = project.include_folders;
  sources.defines = project.defines;
  sources.libraries = {cells_file()};
  sources.kind = RtlSources::Chip;
  return sources;
}

/// A path in the project's folder as the user knows it.
std::string shown(const std::string& file, const TtProject& project) {
  std::error_code error;
  const fs::path inner = fs::weakly_canonical(file, error)
                             .lexically_relative(fs::weakly_canonical(project.folder, error));
  return lies_in(file, project.folder) ? (fs::path(project.folder) / inner).string() : file;
}

[[noreturn]] void refuse(const RtlSyntax::Place& place, const TtProject& project,
                         const std::string& what) {
  throw UsageError(fmt::format("{}:{}: {}; --trust if you trust this project",
                               shown(place.file, project), place.line, what));
}

void check_trust(const RtlSyntax& syntax, const RtlSources& sources, const TtProject& project) {
  for (const RtlSyntax::Place& call : syntax.calls)
    refuse(call, project,
           call.name +
               " reaches beyond the simulation: a project must not run commands nor write "
               "files");
  const auto allowed = [&](const std::string& file) {
    return lies_in(file, project.folder) || file == sources.libraries[0] ||
           std::any_of(project.trusted_folders.begin(), project.trusted_folders.end(),
                       [&](const std::string& folder) { return lies_in(file, folder); });
  };
  for (const std::string& file : syntax.files)
    if (!allowed(file))
      refuse({file, 1, ""}, project, "an include or source outside of " + project.folder);
  for (const RtlSyntax::Place& read : syntax.reads) {
    if (read.name.empty())
      refuse(read, project, "a file is read whose name is only known when the RTL runs");
    if (!allowed((fs::path(project.source_folder) / read.name).string()))
      refuse(read, project,
             fmt::format("{} is read, which lies outside of {}", read.name, project.folder));
  }
}

/// What the test of the project defines and this run does not.
std::string hint(const TtProject& project) {
  std::string words;
  for (const std::string& define : project.test_defines)
    if (std::find(project.defines.begin(), project.defines.end(), define) == project.defines.end())
      words += " --define " + define;
  return words.empty() ? ""
                       : fmt::format("{} defines what may be missing:{}",
                                     (fs::path(project.folder) / "test/Makefile").string(), words);
}

}  // namespace

std::string tt_plugin(const TtProject& project, bool trust, bool signals) {
  RtlSources sources = sources_of(project);
  sources.signals = signals;
  try {
    if (!trust) check_trust(read_rtl_syntax(sources), sources, project);
    const std::string plugin = rtl_plugin(sources);
    warn_of_circular_logic(rtl_library(plugin).model());
    return plugin;
  } catch (const RtlError& error) {
    const std::string text = error.what(), more = hint(project);
    throw RtlError(more.empty() ? text : text + (text.back() == '\n' ? "" : "\n") + more);
  }
}

}  // namespace racebeam
