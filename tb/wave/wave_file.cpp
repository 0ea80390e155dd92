// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/wave/wave_file.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "tb/base/errors.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

// Ctrl-C on a terminal is for us, who finish the file: vcd2fst has a process group of its own.
bool vcd2fst(std::string from, std::string to) {
  std::string program = "vcd2fst";
  char* const words[] = {program.data(), from.data(), to.data(), nullptr};
  posix_spawn_file_actions_t quiet;
  posix_spawn_file_actions_init(&quiet);
  posix_spawn_file_actions_addopen(&quiet, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawnattr_t apart;
  posix_spawnattr_init(&apart);
  posix_spawnattr_setflags(&apart, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&apart, 0);
  pid_t child = 0;
  const int error = posix_spawnp(&child, words[0], &quiet, &apart, words, environ);
  posix_spawnattr_destroy(&apart);
  posix_spawn_file_actions_destroy(&quiet);
  int status = 0;
  return error == 0 && waitpid(child, &status, 0) == child && status == 0;
}

}  // namespace

bool is_waveform(const std::string& path) { return is_fst(path) || extension_of(path) == ".vcd"; }
bool is_fst(const std::string& path) { return extension_of(path) == ".fst"; }

void check_waveform_name(const std::string& path) {
  if (!is_waveform(path)) throw UsageError(path + ": a waveform ends with .vcd or .fst");
  if (is_fst(path) && std::system("command -v vcd2fst >/dev/null") != 0)
    throw MissingTool("vcd2fst is not installed; install the package `gtkwave`, or write a .vcd");
}

WaveFile::WaveFile(const std::string& path) {
  if (!is_fst(path)) {
    vcd_ = std::make_unique<OutputFile>(path);
    return;
  }
  fst_ = std::make_unique<OutputFile>(path);
  made_of_ = fst_->temporary_path() + ".vcd";
  vcd_ = std::make_unique<OutputFile>(made_of_);
}

WaveFile::~WaveFile() {
  std::error_code ignored;
  if (!made_of_.empty()) fs::remove(made_of_, ignored);
}

void WaveFile::finish() {
  if (!fst_) {
    vcd_->finish();
    return;
  }
  vcd_->commit();
  if (!vcd2fst(made_of_, fst_->temporary_path())) throw OutputError(fst_->path(), "vcd2fst failed");
  fst_->finish(1);
}

void WaveFile::commit() { (fst_ ? fst_ : vcd_)->commit(); }

}  // namespace racebeam
