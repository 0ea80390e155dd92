// Runs the program racebeam as a user does and keeps what it says.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fcntl.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/scratch_folder.h"

namespace racebeam {

inline std::string read_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// One run of the program in a folder. Ends with the object.
class Program {
 public:
  struct Setting {
    std::string stdout_path = {};         ///< instead of a file for out()
    rlim_t largest_file = RLIM_INFINITY;  ///< bytes: a full disk
    bool terminal = false;                ///< stderr is one
    std::string environment = {};         ///< one more NAME=VALUE
    bool group = false;                   ///< leads a process group, as on a terminal
    std::string program = RACEBEAM_BINARY;
  };

  Program(const std::string& folder, const std::vector<std::string>& arguments)
      : Program(folder, arguments, Setting()) {}
  Program(const std::string& folder, const std::vector<std::string>& arguments,
          const Setting& setting)
      : out_path_(setting.stdout_path.empty() ? said_ / "out" : setting.stdout_path) {
    int screen = -1;
    if (setting.terminal && openpty(&terminal_, &screen, nullptr, nullptr, nullptr) != 0)
      throw std::runtime_error("no terminal");
    pid_ = fork();
    if (setting.group) setpgid(pid_, pid_);  // both sides: whoever comes first
    if (pid_ == 0) become(folder, arguments, setting, screen);
    if (screen >= 0) close(screen);
  }
  ~Program() {
    if (pid_ > 0) kill(pid_, SIGKILL);
    wait();
    if (terminal_ >= 0) close(terminal_);
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void signal(int number) const { kill(pid_, number); }
  /// To all of its process group: Ctrl-C on a terminal. With Setting::group.
  void signal_group(int number) const { kill(-pid_, number); }
  int id() const { return pid_; }
  /// It has not ended, or nobody has waited for it.
  bool runs() const {
    siginfo_t info{};
    return pid_ > 0 && waitid(P_PID, id_t(pid_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           info.si_pid == 0;
  }
  /// Processes that it has started and that live.
  int children() const { return static_cast<int>(children_ids().size()); }
  std::vector<int> children_ids() const {
    const std::string process = std::to_string(pid_);
    std::istringstream all(read_file("/proc/" + process + "/task/" + process + "/children"));
    return {std::istream_iterator<int>(all), {}};
  }
  /// What it has said on stderr so far.
  std::string said() const { return read_file(said_ / "err"); }

  /// Waits for the end. The exit code, or -signal if it was killed.
  int wait() {
    if (pid_ < 0) return code_;
    while (terminal_ >= 0 && read_terminal()) {
    }
    int status = 0;
    while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    pid_ = -1;
    code_ = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    return code_;
  }
  /// Until its terminal has shown `text`, or it has ended.
  void wait_for(const std::string& text) {
    while (screen_.find(text) == std::string::npos && read_terminal()) {
    }
  }
  std::string out() {
    wait();
    return read_file(out_path_);
  }
  std::string err() {
    wait();
    return terminal_ >= 0 ? screen_ : read_file(said_ / "err");
  }
  nlohmann::json json() { return nlohmann::json::parse(out()); }

 private:
  [[noreturn]] void become(const std::string& folder, const std::vector<std::string>& arguments,
                           const Setting& setting, int screen) {
    const int out = open(out_path_.c_str(), O_WRONLY | O_CREAT, 0644);
    const int err = screen >= 0 ? screen : open((said_ / "err").c_str(), O_WRONLY | O_CREAT, 0644);
    dup2(out, STDOUT_FILENO);
    dup2(err, STDERR_FILENO);
    setenv("TERM", "xterm", 1);
    unsetenv("CI");
    std::string extra = setting.environment;
    if (!extra.empty()) putenv(extra.data());
    const rlimit limit{setting.largest_file, RLIM_INFINITY};
    if (setting.largest_file != RLIM_INFINITY) setrlimit(RLIMIT_FSIZE, &limit);
    std::vector<char*> words = {const_cast<char*>("racebeam")};
    for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    if (chdir(folder.c_str()) == 0) execv(setting.program.c_str(), words.data());
    _exit(127);
  }
  bool read_terminal() {
    char some[4096];
    const ssize_t n = read(terminal_, some, sizeof some);
    if (n > 0) screen_.append(some, n);
    return n > 0;
  }

  ScratchFolder said_;
  const std::string out_path_;
  int terminal_ = -1;
  std::string screen_;
  pid_t pid_ = -1;
  int code_ = 0;
};

}  // namespace racebeam
