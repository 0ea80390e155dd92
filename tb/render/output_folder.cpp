// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/render/output_folder.h"

#include <algorithm>
#include <system_error>

#include "tb/base/errors.h"
#include "tb/base/output_file.h"
#include "tb/base/text_pattern.h"
#include "tb/base/whole_file.h"
#include "tb/picture/picture_format.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

constexpr const char* ManifestName = "manifest.json";
constexpr const char* StatsName = "stats.json";
constexpr std::size_t Told = 4;  // differences in a message
constexpr const char* Otherwise = "; name another folder with -o, or replace it: --overwrite";

}  // namespace

OutputFolder::OutputFolder(const std::string& path, const Manifest& what, bool overwrite)
    : path_(path),
      what_(what),
      overwrite_(overwrite),
      made_(make_folder(path)),
      lock_(path_.string()) {
  if (!lock_.take())
    throw UsageError("another render writes to " + path_.string() +
                     "; wait until it ends, or name another folder with -o");
  std::error_code ignored;
  if (overwrite) return;
  if (!fs::exists(path_ / ManifestName, ignored)) {
    for (const auto& entry : fs::directory_iterator(path_, ignored))
      if (const std::string name = entry.path().filename(); owns(name))
        throw UsageError(path_.string() + " has " + name + ", but no " + ManifestName +
                         " that says how it was made" + Otherwise);
    return;
  }
  before_ = whole_file(path_ / ManifestName);
  check(what);
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  if (!started_)
    for (const std::string& level : made_) fs::remove(level, ignored);
}

void OutputFolder::check(const Manifest& what) const {
  std::vector<std::string> differences;
  try {
    differences = what.differences(before_);
  } catch (const UsageError& error) {
    throw UsageError(file(ManifestName) + " is in the way: " + error.what() + Otherwise);
  }
  if (differences.empty()) return;
  std::string text;
  for (std::size_t i = 0; i < std::min(differences.size(), Told); ++i)
    text += (i ? "; " : "") + differences[i];
  if (differences.size() > Told)
    text += "; and " + std::to_string(differences.size() - Told) + " more";
  throw UsageError(path_.string() + " has frames of another render: " + text + Otherwise);
}

void OutputFolder::start() {
  started_ = true;
  std::error_code ignored;
  if (overwrite_)
    for (const auto& entry : fs::directory_iterator(path_, ignored))
      if (owns(entry.path().filename().string())) fs::remove(entry.path(), ignored);
  if (before_.empty()) write_text(file(ManifestName), what_.text());
}

std::string OutputFolder::name_of(const std::string& path) const {
  std::error_code ignored;
  const fs::path here = fs::weakly_canonical(fs::absolute(path_), ignored);
  return fs::weakly_canonical(fs::absolute(path), ignored).lexically_proximate(here).string();
}

void OutputFolder::write(Manifest manifest) const {
  if (!before_.empty()) manifest.add_earlier(before_);
  write_text(file(ManifestName), manifest.text());
}

void OutputFolder::abandon() const {
  std::error_code ignored;
  if (before_.empty()) fs::remove(path_ / ManifestName, ignored);
}

bool OutputFolder::owns(const std::string& name) {
  static const TextPattern picture(R"((frame|difference|overlay_[a-z]+)_[0-9]+\.[a-z]+)");
  return name == ManifestName || name == StatsName ||
         (picture.matches(name) && format_of_file(name));
}

}  // namespace racebeam
