// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/shared_work.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <list>
#include <vector>

#include "sc/swap/rtl_library.h"
#include "tb/base/child.h"
#include "tb/base/errors.h"
#include "tb/base/forked.h"
#include "tb/base/interrupt.h"

namespace racebeam {

namespace {

constexpr int Pause = 100;  // milliseconds
constexpr char Line = 'L', Error = 'E';

class Process {
 public:
  Process(int number, const std::function<void(int, const SayLine&)>& work) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe to a child process");
    child_ = fork_child();
    if (child_ == 0) {
      close(ends[0]);
      run(number, work, ends[1]);
    }
    close(ends[1]);
    file_ = ends[0];
    if (child_ < 0) throw std::runtime_error("no child process");
  }
  ~Process() {
    close(file_);
    if (child_ <= 0) return;
    kill(child_, SIGKILL);  // it writes no files
    wait_for_child(child_);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  int file() const { return file_; }
  /// Takes what it has said; false once it has ended.
  bool read(const std::function<void(const std::string&)>& take) {
    char buffer[4096];
    const ssize_t got = ::read(file_, buffer, sizeof buffer);
    if (got < 0 && errno == EINTR) return true;
    if (got <= 0) {
      const int status = wait_for_child(child_);
      child_ = 0;
      if (status != 0) throw ChildDied(death_of("a child process", status));
      return false;
    }
    said_.append(buffer, static_cast<std::size_t>(got));
    for (std::size_t end; (end = said_.find('\n')) != std::string::npos;) {
      const char kind = said_[0];
      std::string line = said_.substr(1, end - 1);
      said_.erase(0, end + 1);
      if (kind == Error) throw RtlError(line);
      take(line);
    }
    return true;
  }

 private:
  [[noreturn]] static void run(int number, const std::function<void(int, const SayLine&)>& work,
                               int file) {
    const auto say = [file](char kind, std::string line) {
      for (char& c : line)
        if (c == '\n') c = ' ';
      if (!write_all(file, kind + line + "\n")) _exit(0);
    };
    try {
      work(number, [&](const std::string& line) { say(Line, line); });
    } catch (const Interrupted&) {
    } catch (const std::exception& error) {
      say(Error, error.what());
    }
    _exit(0);
  }

  pid_t child_ = 0;
  int file_ = -1;
  std::string said_;
};

}  // namespace

void share_work(int processes, const std::function<void(int number, const SayLine& say)>& work,
                const std::function<void(const std::string& line)>& take) {
  catch_interrupts();
  std::list<Process> all;
  for (int number = 0; number < processes; ++number) all.emplace_back(number, work);
  while (!all.empty()) {
    if (interrupted()) throw Interrupted();
    std::vector<pollfd> waits;
    for (const Process& process : all) waits.push_back({process.file(), POLLIN, 0});
    if (poll(waits.data(), waits.size(), Pause) <= 0) continue;
    auto wait = waits.begin();
    for (auto process = all.begin(); process != all.end(); ++wait)
      process =
          wait->revents != 0 && !process->read(take) ? all.erase(process) : std::next(process);
  }
  if (interrupted()) throw Interrupted();
}

}  // namespace racebeam
