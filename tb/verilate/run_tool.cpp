// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/run_tool.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <list>
#include <sstream>
#include <stdexcept>

#include "tb/base/child.h"
#include "tb/base/errors.h"
#include "tb/base/interrupt.h"

namespace racebeam {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int TickMilliseconds = 80;
constexpr auto NoLimit = std::chrono::hours(24 * 365);

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
  // Locks and pipes of the program: a tool that is slow to die holds none of them.
  const auto kept = static_cast<unsigned>(output);
  close_range(STDERR_FILENO + 1, kept - 1, 0);
  close_range(kept + 1, ~0U, 0);
  if (run.work.count() > 0) {
    const auto most = static_cast<rlim_t>(run.work.count());
    const rlimit work{most, most};
    setrlimit(RLIMIT_CPU, &work);
  }
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

/// A tool that runs. It is ended when this goes, with all that it has started.
class RunningTool {
 public:
  RunningTool(const ToolRun& run, std::size_t number, std::chrono::milliseconds limit)
      : number_(number), tick_(run.tick) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe to a child process");
    output_ = ends[0];
    try {
      child_ = start(run, ends[1]);
    } catch (...) {
      close(ends[0]);
      close(ends[1]);
      throw;
    }
    close(ends[1]);
    deadline_ = Clock::now() + limit;
  }
  ~RunningTool() {
    if (child_ > 0) end();
    close(output_);
  }
  RunningTool(const RunningTool&) = delete;
  RunningTool& operator=(const RunningTool&) = delete;

  std::size_t number() const { return number_; }
  void tick() const {
    if (tick_) tick_();
  }
  /// Becomes readable when it says something, or ends.
  int output() const { return output_; }
  /// Takes what it has said, if `readable`. Its result once it has ended, or has to.
  const ToolResult* look(bool readable) {
    if (readable && !read()) {
      result_.good = wait_for_child(child_) == 0;
      child_ = 0;
      return &result_;
    }
    if (Clock::now() < deadline_) return nullptr;
    end();
    result_.late = true;
    return &result_;
  }

 private:
  bool read() {
    char buffer[4096];
    const ssize_t got = ::read(output_, buffer, sizeof buffer);
    if (got > 0) result_.said.append(buffer, static_cast<std::size_t>(got));
    return got > 0 || (got < 0 && errno == EINTR);
  }
  void end() {
    kill(-child_, SIGKILL);
    wait_for_child(child_);
    child_ = 0;
  }

  const std::size_t number_;
  const std::function<void()> tick_;
  int output_ = -1;
  pid_t child_ = 0;
  Clock::time_point deadline_;
  ToolResult result_{};
};

}  // namespace

ToolResult run_tool(const ToolRun& run) {
  ToolResult result{};
  run_tools({run}, 1, NoLimit, [&result](std::size_t, const ToolResult& end) { result = end; });
  return result;
}

void run_tools(const std::vector<ToolRun>& runs, int jobs, std::chrono::milliseconds limit,
               const std::function<void(std::size_t, const ToolResult&)>& done) {
  for (const ToolRun& run : runs)
    if (!has_tool(run.words[0])) throw MissingTool(run.words[0] + " is not installed");
  catch_interrupts();
  const auto at_once = static_cast<std::size_t>(std::max(1, jobs));
  std::list<RunningTool> running;
  for (std::size_t next = 0; next < runs.size() || !running.empty();) {
    if (interrupted()) throw Interrupted();
    for (; next < runs.size() && running.size() < at_once; ++next)
      running.emplace_back(runs[next], next, limit);
    std::vector<pollfd> waits;
    for (const RunningTool& tool : running) {
      tool.tick();
      waits.push_back({tool.output(), POLLIN, 0});
    }
    poll(waits.data(), waits.size(), TickMilliseconds);
    auto wait = waits.begin();
    for (auto tool = running.begin(); tool != running.end(); ++wait) {
      const ToolResult* result = tool->look(wait->revents != 0);
      if (result) done(tool->number(), *result);
      tool = result ? running.erase(tool) : std::next(tool);
    }
  }
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
