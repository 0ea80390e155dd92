// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/verify_watch.h"

#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <map>
#include <thread>
#include <tuple>

#include "sc/base/unit_choices.h"
#include "sc/swap/rtl_library.h"
#include "tb/base/child.h"
#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/base/guarded.h"
#include "tb/base/interrupt.h"
#include "tb/base/project_folder.h"
#include "tb/show/open_show.h"
#include "tb/verilate/gate_netlist.h"
#include "tb/verilate/source_list.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

constexpr auto Pause = std::chrono::milliseconds(100);

/// What tells a saved file from what it was; an editor may write another in its place.
using State = std::tuple<ino_t, off_t, time_t, long>;

/// Files and folders as they were.
class Snapshot {
 public:
  void add(const std::string& path) { states_.emplace(path, state(path)); }
  /// One of them is another now, and is there.
  bool differs() const {
    for (const auto& [path, before] : states_)
      if (const State now = state(path); now != before && now != State{}) return true;
    return false;
  }
  std::size_t size() const { return states_.size(); }

 private:
  static State state(const std::string& path) {
    struct stat facts {};
    if (stat(path.c_str(), &facts) != 0) return {};
    return {facts.st_ino, facts.st_size, facts.st_mtim.tv_sec, facts.st_mtim.tv_nsec};
  }
  std::map<std::string, State> states_;
};

/// The files of a word such as "stacks", "all" or "stacks=mine.sv".
std::vector<std::string> files_of(const std::string& word) {
  const auto equals = word.find('=');
  if (word == "all") {
    std::vector<std::string> all;
    for (const std::string& folder : rtl_folders())
      for (const auto& entry : fs::directory_iterator(folder)) all.push_back(entry.path());
    return all;
  }
  const std::string unit = word.substr(0, equals);
  std::string text = equals == std::string::npos ? rtl_file(unit) : word.substr(equals + 1);
  if (const auto gates = gate_word(text)) text = gates->file.empty() ? rtl_file(unit) : gates->file;
  return is_source_list(text) ? files_of_list(unit, text) : std::vector<std::string>{text};
}

std::vector<std::string> paths_of(const std::vector<std::string>& words) {
  std::vector<std::string> paths;
  for (const std::string& word : words)
    for (const std::string& path : files_of(word)) paths.push_back(path);
  return paths;
}

/// Ends with what `verify` returns; a Ctrl-C goes on to it.
int run(const VerifyOptions& options) {
  const pid_t child = fork_child();
  if (child < 0) throw MissingTool("there is no place for another process");
  if (child == 0) {
    const int code = guarded([&] { return command_verify(options); });
    std::fflush(nullptr);
    _exit(code);
  }
  int status = 0;
  for (bool told = false; waitpid(child, &status, WNOHANG) == 0;) {
    if (interrupted() && !told) kill(child, SIGTERM);
    told = interrupted();
    std::this_thread::sleep_for(Pause / 5);
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : ExitDifference;
}

}  // namespace

int verify_watch(const VerifyOptions& options) {
  plan_verify(options);  // what is wrong now cannot be mended by saving RTL
  catch_interrupts();
  std::vector<std::string> words = options.units;
  if (words.empty()) words = {"all"};
  std::vector<std::string> paths;
  while (!interrupted()) {
    try {
      paths = paths_of(words);
    } catch (const UsageError&) {
      if (paths.empty()) throw;  // later a file may be away for a moment
    }
    Snapshot files;
    for (const std::string& path : paths) files.add(path);
    if (const std::string scene = scene_path(options.scene); fs::exists(scene)) files.add(scene);
    if (run(options) == ExitInterrupted || interrupted()) break;
    const std::string more = std::to_string(files.size() - 1);
    tell("waiting until " + paths.front() +
         (files.size() > 1 ? " or one of " + more + " more" : "") + " is saved; Ctrl-C ends");
    while (!interrupted() && !files.differs()) std::this_thread::sleep_for(Pause);
    std::this_thread::sleep_for(Pause);  // until the editor is through
  }
  return ExitInterrupted;
}

}  // namespace racebeam
