// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/cli/program.h"

#include <fcntl.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace racebeam {

std::string read_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

Json read_json(const std::string& path) { return Json::parse(read_file(path)); }

Program::Program(const std::string& folder, const std::vector<std::string>& arguments,
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

Program::~Program() {
  if (pid_ > 0) kill(pid_, SIGKILL);
  wait();
  if (terminal_ >= 0) close(terminal_);
}

void Program::signal(int number) const { kill(pid_, number); }
void Program::signal_group(int number) const { kill(-pid_, number); }

bool Program::runs() const {
  siginfo_t info{};
  return pid_ > 0 && waitid(P_PID, id_t(pid_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
         info.si_pid == 0;
}

std::vector<int> Program::children_ids() const {
  const std::string process = std::to_string(pid_);
  std::istringstream all(read_file("/proc/" + process + "/task/" + process + "/children"));
  return {std::istream_iterator<int>(all), {}};
}

int Program::wait() {
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

void Program::wait_for(const std::string& text) {
  while (screen_.find(text) == std::string::npos && read_terminal()) {
  }
}

std::string Program::out() {
  wait();
  return read_file(out_path_);
}

std::string Program::err() {
  wait();
  return terminal_ >= 0 ? screen_ : read_file(said_ / "err");
}

void Program::become(const std::string& folder, const std::vector<std::string>& arguments,
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

bool Program::read_terminal() {
  char some[4096];
  const ssize_t n = read(terminal_, some, sizeof some);
  if (n > 0) screen_.append(some, n);
  return n > 0;
}

}  // namespace racebeam
