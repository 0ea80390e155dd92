// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/elaborated.h"

#include <filesystem>
#include <fstream>
#include <set>
#include <vector>

#include "tb/base/errors.h"
#include "tb/verilate/cache_folder.h"
#include "tb/verilate/syntax_tree.h"
#include "tb/verilate/verilator.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

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

std::string content_of(std::vector<std::string> settings, const std::vector<std::string>& files) {
  for (const std::string& file : files) {
    settings.push_back(file);
    settings.push_back(file_key(file));
  }
  return content_key(settings);
}

}  // namespace

// Which files are read is only known afterwards. The list of the last time is kept under the name
// of the request; the XML under that of all that the listed files hold.
Elaborated elaborated(const RtlSources& sources) {
  for (const std::string& file : sources.files)
    if (!fs::is_regular_file(file)) throw UsageError("there is no file '" + file + "'");
  std::vector<std::string> settings = source_words(sources);
  settings.push_back(sources.top);
  settings.push_back(verilator_version());
  std::vector<std::string> request = settings;
  for (const std::string& folder : searched_folders(sources))
    for (const std::string& name : sources_in(folder)) request.push_back(name);
  const std::string list = content_key(request) + ".files";

  if (const std::string known = in_cache(list); !known.empty()) {
    const std::string content = content_of(settings, lines_of(known));
    if (const std::string xml = in_cache(content + ".xml"); !xml.empty()) return {xml, content};
  }
  const WorkFolder work;
  write_rtl_xml(sources, work.path(), work.file("tree.xml"));
  leave_out_lists(work.file("tree.xml"));
  const std::vector<std::string> files = SyntaxTree(work.file("tree.xml")).files();
  const std::string content = content_of(settings, files);
  std::ofstream names(work.file("files"));
  for (const std::string& file : files) names << file << '\n';
  names.close();
  put_in_cache(work.file("files"), list);
  return {put_in_cache(work.file("tree.xml"), content + ".xml"), content};
}

}  // namespace racebeam
