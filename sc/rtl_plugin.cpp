// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/rtl_plugin.h"

#include <unistd.h>

#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <sstream>
#include <utility>

namespace racebeam {

namespace fs = std::filesystem;

namespace {

// interval_stack_depth -> IntervalStackDepth
std::string parameter_name(const std::string& knob) {
  std::string name;
  bool capital = true;
  for (const char c : knob) {
    if (c != '_') name += capital ? static_cast<char>(std::toupper(c)) : c;
    capital = c == '_';
  }
  return name;
}

/// The knobs that RTL knows, by the names of its parameters.
std::vector<std::pair<std::string, int>> parameter_values(const knobs& k) {
  std::vector<std::pair<std::string, int>> values;
  for (const auto& row : knob_table()) values.emplace_back(parameter_name(row.name), k.*row.member);
  values.emplace_back("NavigatorBits", k.navigator_bits);
  values.emplace_back("FreeFlight", k.free_flight);
  values.emplace_back("PortalsPerFace", k.portals_per_face);
  return values;
}

std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

fs::path program_folder() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error).parent_path();
}

/// The folder with scripts/verilate and rtl/: the sources, or where they are installed.
fs::path project_folder() {
  std::error_code error;
  const fs::path installed = program_folder() / "../share/racebeam";
  return fs::exists(installed / "scripts/verilate", error) ? installed : fs::path(RACEBEAM_ROOT);
}

/// Where plug-ins that are made of another's RTL lie: beside it, or, where an installed program may
/// not write, in the user's cache. Throws RtlError.
fs::path folder_beside(const fs::path& plugin) {
  const fs::path beside = plugin.parent_path();
  if (access(beside.c_str(), W_OK) == 0) return beside;
  const char *cache = std::getenv("XDG_CACHE_HOME"), *home = std::getenv("HOME");
  const fs::path caches = cache && *cache ? fs::path(cache)
                          : home          ? fs::path(home) / ".cache"
                                          : fs::path();
  // Several installations do not share what they build.
  const auto installation = std::to_string(std::hash<std::string>{}(beside.string()));
  const fs::path own = caches / "racebeam" / installation;
  std::error_code error;
  if (!caches.empty()) fs::create_directories(own, error);
  if (access(own.c_str(), W_OK) == 0) return own;
  throw RtlError("RTL with other parameters must be built, but neither " + beside.string() +
                 " nor a cache folder can be written; set XDG_CACHE_HOME to a folder of yours");
}

/// Runs scripts/verilate: the plug-in appears whole or not at all. Throws RtlError.
void verilate(const std::string& switches, const std::string& module, const std::string& options,
              const std::vector<std::string>& sources, const std::string& out) {
  const std::string log = out + ".log", fresh = out + "." + std::to_string(getpid());
  std::string command = quoted((project_folder() / "scripts/verilate").string()) + switches + " " +
                        quoted(module) + " " + quoted(fresh) + options;
  for (const std::string& source : sources) command += " " + quoted(fs::absolute(source).string());
  const int status = std::system((command + " >" + quoted(log) + " 2>&1").c_str());
  std::ifstream in(log);
  const std::string said{std::istreambuf_iterator<char>(in), {}};
  std::error_code ignored;
  fs::remove(log, ignored);
  if (status != 0) {
    fs::remove(fresh, ignored);
    throw RtlError("the RTL of " + module + " (" + joined(sources, ", ") +
                   ") cannot be verilated:\n" + said);
  }
  fs::rename(fresh, out);
}

}  // namespace

std::string rtl_folder() { return (project_folder() / "rtl").string(); }

std::string rtl_plugin_path(const std::string& unit, const knobs& k, bool traced) {
  std::error_code error;
  fs::path path = program_folder() / "rtl" / (unit + ".so");
  const fs::path installed = program_folder() / "../lib/racebeam" / (unit + ".so");
  if (!fs::exists(path, error) && fs::exists(installed, error)) path = installed;
  const std::vector<std::string> other = other_parameters(rtl_library(path.string()).model(), k);
  traced = traced && rtl_library(path.string()).model().signal_count == 0;
  if (other.empty() && !traced) return path.string();
  std::vector<std::string> words = {unit};
  words.insert(words.end(), other.begin(), other.end());
  if (traced) words.emplace_back("trace");
  const fs::path variant = folder_beside(path) / (joined(words, ".") + ".so");
  if (!fs::exists(variant, error) ||
      fs::last_write_time(variant, error) < fs::last_write_time(path, error))
    build_rtl_plugin(unit, {}, other, variant.string(), traced);
  return variant.string();
}

std::vector<std::string> other_parameters(const rtl_model& model, const knobs& k) {
  std::map<std::string, int> built;  // the last setting counts
  std::istringstream words(model.parameters);
  for (std::string word; words >> word;) {
    const auto equals = word.find('=');
    if (equals != std::string::npos)
      built[word.substr(0, equals)] = std::stoi(word.substr(equals + 1));
  }
  std::vector<std::string> other;
  for (const auto& [name, value] : parameter_values(k))
    if (const auto at = built.find(name); at != built.end() && at->second != value)
      other.push_back(name + "=" + std::to_string(value));
  return other;
}

void build_rtl_plugin(const std::string& unit, std::vector<std::string> sources,
                      const std::vector<std::string>& parameters, const std::string& out,
                      bool traced) {
  if (sources.empty()) sources = {rtl_folder() + "/" + unit + ".sv"};
  std::string options;
  for (const std::string& parameter : parameters) options += " " + quoted("-G" + parameter);
  verilate(traced ? " --signals" : "", unit, options, sources, out);
}

void build_chip_plugin(const std::string& top, const std::vector<std::string>& sources,
                       const std::string& out) {
  verilate(" --registered", top, "", sources, out);
}

}  // namespace racebeam
