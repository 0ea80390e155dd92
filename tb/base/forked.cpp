// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/base/forked.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

#include "sc/swap/rtl_library.h"
#include "tb/base/child.h"
#include "tb/base/errors.h"
#include "tb/base/interrupt.h"
#include "tb/base/output_file.h"

namespace racebeam {

namespace {

constexpr int Pause = 100;  // milliseconds

/// Exit codes of a child whose answer is an error, unlike those of a program that ends by itself.
enum Thrown { Other = 64, Usage, Missing, Rtl, Stopped };

/// What a child writes until it closes its end. An interrupt is passed on to it, which may have
/// come to us alone.
std::string answer_of(pid_t child, int file) {
  std::string text;
  bool told = false;
  for (;;) {
    if (interrupted() && !told) {
      told = true;
      time_to_finish();
      kill(child, SIGTERM);
    }
    pollfd waits{file, POLLIN, 0};
    if (poll(&waits, 1, Pause) <= 0) continue;  // the signal may come just before poll()
    char buffer[4096];
    const ssize_t got = read(file, buffer, sizeof buffer);
    if (got == 0 || (got < 0 && errno != EINTR)) return text;
    if (got > 0) text.append(buffer, static_cast<std::size_t>(got));
  }
}

}  // namespace

bool write_all(int file, const std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t wrote = write(file, bytes.data() + done, bytes.size() - done);
    if (wrote < 0 && errno != EINTR) return false;
    if (wrote > 0) done += static_cast<std::size_t>(wrote);
  }
  return true;
}

std::string forked(const std::function<std::string()>& work) {
  int pipe_ends[2];
  if (pipe2(pipe_ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe to a child process");
  const pid_t child = fork_child();
  if (child < 0) throw std::runtime_error("no child process");
  if (child == 0) {
    close(pipe_ends[0]);
    int status = 0;
    std::string answer;
    try {
      answer = work();
    } catch (const RtlError& error) {
      answer = error.what();
      status = Rtl;
    } catch (const UsageError& error) {
      answer = error.what();
      status = Usage;
    } catch (const OutputError& error) {
      answer = error.what() + std::string("; choose another place, or free some space");
      status = Usage;
    } catch (const MissingTool& error) {
      answer = error.what();
      status = Missing;
    } catch (const Interrupted&) {
      status = Stopped;
    } catch (const std::exception& error) {
      answer = error.what();
      status = Other;
    }
    write_all(pipe_ends[1], answer);
    _exit(status);
  }
  close(pipe_ends[1]);
  const std::string answer = answer_of(child, pipe_ends[0]);
  close(pipe_ends[0]);
  const int status = wait_for_child(child);
  if (status == 0) return answer;
  switch (WIFEXITED(status) ? WEXITSTATUS(status) : 0) {
    case Rtl: throw RtlError(answer);
    case Usage: throw UsageError(answer);
    case Missing: throw MissingTool(answer);
    case Stopped: throw Interrupted();
    case Other: throw std::runtime_error(answer);
  }
  if (interrupted()) throw Interrupted();
  throw ChildDied(death_of("a child process", status));
}

}  // namespace racebeam
