// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/elaborated.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <vector>

#include "sc/swap/rtl_library.h"
#include "tb/base/errors.h"
#include "tb/verilate/cache_folder.h"
#include "tb/verilate/syntax_tree.h"
#include "tb/verilate/verilator.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

constexpr int MostRuns = 5;  // of Verilator, while files change

/// Sources that lie in a folder: a new one may come before another of that name.
std::set<std::string> sources_in(const std::string& folder) {
  static const std::set<std::string> Extensions = {".v", ".sv", ".vh", ".svh"};
  std::set<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (Extensions.count(entry.path().extension().string()) != 0)
      names.insert(entry.path().string());
  return names;
}

std::vector<std::string> lines_of(const std::string& path) {
  std::vector<std::string> lines;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// What each file holds, by its path.
using FileKeys = std::map<std::string, std::string>;

void look_at(const std::vector<std::string>& files, FileKeys& keys) {
  for (const std::string& file : files) keys[file] = file_key(file);
}

std::string content_of(std::vector<std::string> settings, const std::vector<std::string>& files,
                       const FileKeys& keys) {
  for (const std::string& file : files) {
    settings.push_back(file);
    settings.push_back(keys.at(file));
  }
  return content_key(settings);
}

void write_lines(const std::string& path, const std::vector<std::string>& lines) {
  std::ofstream out(path);
  for (const std::string& line : lines) out << line << '\n';
  out.close();
  if (!out) throw RtlError("cannot write " + path + "; is the disk full?");
}

/// Runs Verilator until no file changes meanwhile, and keeps the XML and, as `list`, the files.
/// `before` is what some of them held until now.
Elaborated elaborate(const RtlSources& sources, const std::vector<std::string>& settings,
                     const std::string& list, FileKeys before) {
  for (int run = 0; run < MostRuns; ++run) {
    const WorkFolder work;
    const std::string xml = work.file("tree.xml");
    write_rtl_xml(sources, work.path(), xml);
    leave_out_lists(xml);
    const std::vector<std::string> files = SyntaxTree(xml).files();
    FileKeys after;
    look_at(files, after);
    const bool same = std::all_of(after.begin(), after.end(), [&](const auto& file) {
      const auto at = before.find(file.first);
      return at != before.end() && at->second == file.second;
    });
    if (same) {
      const std::string content = content_of(settings, files, after);
      write_lines(work.file("files"), files);
      put_in_cache(work.file("files"), list);
      return {put_in_cache(xml, content + ".xml"), content};
    }
    for (const auto& [file, key] : after) before[file] = key;
  }
  throw RtlError("the files of " + sources.top + " change while Verilator reads them; try again");
}

}  // namespace

// Which files are read is only known afterwards. The list of the last time is kept under the name
// of the request; the XML under that of all that the listed files held, before Verilator read them
// and afterwards.
Elaborated elaborated(const RtlSources& sources) {
  for (const std::string& file : sources.files)
    if (!fs::is_regular_file(file)) throw UsageError("there is no file '" + file + "'");
  std::vector<std::string> settings = source_words(sources), candidates;
  settings.push_back(sources.top);
  settings.push_back(verilator_version() + " --assert");
  for (const std::string& file : sources.files)
    candidates.push_back(fs::absolute(file).lexically_normal().string());
  for (const std::string& folder : searched_folders(sources))
    for (const std::string& name : sources_in(folder)) candidates.push_back(name);
  std::vector<std::string> request = settings;
  request.insert(request.end(), candidates.begin(), candidates.end());
  request.emplace_back("2");  // another one whenever lists become others
  const std::string list = content_key(request) + ".files";

  FileKeys keys;
  if (const std::string known = in_cache(list); !known.empty()) {
    const std::vector<std::string> files = lines_of(known);
    look_at(files, keys);
    const std::string content = content_of(settings, files, keys);
    if (const std::string xml = in_cache(content + ".xml"); !xml.empty()) return {xml, content};
  }
  look_at(candidates, keys);
  return elaborate(sources, settings, list, keys);
}

}  // namespace racebeam
