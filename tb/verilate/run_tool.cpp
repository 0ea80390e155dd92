// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/run_tool.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "tb/base/child.h"
#include "tb/base/errors.h"
#include "tb/base/interrupt.h"

namespace racebeam {

namespace {

constexpr int TickMilliseconds = 80;

std::vector<char*> pointers(const std::vector<std::string>& words) {
  std::vector<char*> all;
  for (const std::string& word : words) all.push_back(const_cast<char*>(word.c_str()));
  all.push_back(nullptr);
  return all;
}

std::vector<std::string> environment_with(const std::vector<std::string>& more) {
  std::vector<std::string> all;
  for (char** entry = environ; *entry; ++entry) all.emplace_back(*entry);
  for (const std::string& setting : more) {
    const std::string name = setting.substr(0, setting.find('=') + 1);
    for (auto at = all.begin(); at != all.end();)
      at = at->rfind(name, 0) == 0 ? all.erase(at) : at + 1;
    all.push_back(setting);
  }
  return all;
}

/// Starts it with `output` as its stdout and stderr; 0 or the error, its id in `tool`.
int spawn(const ToolRun& run, int output, pid_t& tool) {
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&files, output, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, output, STDERR_FILENO);
  if (!run.folder.empty()) posix_spawn_file_actions_addchdir_np(&files, run.folder.c_str());
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none, usual;
  sigemptyset(&none);
  sigemptyset(&usual);
  for (const int number : {SIGPIPE, SIGXFSZ, SIGINT, SIGTERM, SIGHUP}) sigaddset(&usual, number);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setsigdefault(&attributes, &usual);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  const std::vector<std::string> environment = environment_with(run.environment);
  const int error = posix_spawnp(&tool, run.words[0].c_str(), &files, &attributes,
                                 pointers(run.words).data(), pointers(environment).data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  return error;
}

void end_group(int) { kill(0, SIGKILL); }

/// Between the program and a tool: leads the process group of all that the tool starts, and ends it
/// when the program ends, even by SIGKILL. Returns its id.
pid_t start(const ToolRun& run, int output) {
  const pid_t keeper = fork_child();
  if (keeper < 0) throw MissingTool("there is no place for another process");
  setpgid(keeper, keeper);
  if (keeper != 0) return keeper;
  prctl(PR_SET_NAME, "racebeam-tool");
  signal(SIGTERM, end_group);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  pid_t tool = 0;
  if (const int error = spawn(run, output, tool)) {
    dprintf(output, "%s cannot be started: %s\n", run.words[0].c_str(), std::strerror(error));
    _exit(1);
  }
  const int status = wait_for_child(tool);
  if (WIFSIGNALED(status))
    dprintf(output, "%s was ended by signal %d\n", run.words[0].c_str(), WTERMSIG(status));
  _exit(status == 0 ? 0 : 1);
}

/// A pipe that children get only as their output.
class Pipe {
 public:
  Pipe() {
    if (pipe2(ends_, O_CLOEXEC) != 0) throw std::runtime_error("no pipe to a child process");
  }
  ~Pipe() {
    close_writer();
    close(ends_[0]);
  }
  int reader() const { return ends_[0]; }
  int writer() const { return ends_[1]; }
  void close_writer() {
    if (ends_[1] >= 0) close(ends_[1]);
    ends_[1] = -1;
  }

 private:
  int ends_[2];
};

}  // namespace

ToolResult run_tool(const ToolRun& run) {
  if (!has_tool(run.words[0])) throw MissingTool(run.words[0] + " is not installed");
  catch_interrupts();
  Pipe pipe;
  const pid_t child = start(run, pipe.writer());
  pipe.close_writer();
  ToolResult result{};
  for (bool open = true; open;) {
    if (interrupted()) {
      kill(-child, SIGKILL);
      wait_for_child(child);
      throw Interrupted();
    }
    if (run.tick) run.tick();
    pollfd wait{pipe.reader(), POLLIN, 0};
    if (poll(&wait, 1, TickMilliseconds) <= 0) continue;
    char buffer[4096];
    const ssize_t got = read(pipe.reader(), buffer, sizeof buffer);
    if (got > 0) result.said.append(buffer, static_cast<std::size_t>(got));
    else open = got < 0 && errno == EINTR;
  }
  result.good = wait_for_child(child) == 0;
  return result;
}

bool has_tool(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  std::error_code error;
  for (std::string folder; std::getline(folders, folder, ':');) {
    const auto file = std::filesystem::path(folder) / name;
    if (std::filesystem::is_regular_file(file, error) && access(file.c_str(), X_OK) == 0)
      return true;
  }
  return false;
}

}  // namespace racebeam
