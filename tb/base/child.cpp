// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/base/child.h"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include "tb/base/errors.h"

namespace racebeam {

pid_t fork_child() {
  std::fflush(nullptr);  // or both would write it
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child != 0) return child;
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);  // it ended before that
  return 0;
}

int wait_for_child(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

std::string death_of(const std::string& what, int status) {
  if (!WIFSIGNALED(status)) return what + " ended with " + std::to_string(WEXITSTATUS(status));
  const int number = WTERMSIG(status);
  return what + " died: " + strsignal(number) +
         (number == SIGKILL ? "; is there memory left?" : "");
}

void throw_death(const std::string& what, int status) {
  const std::string text = death_of(what, status);
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) throw MissingTool(text);
  if (WIFEXITED(status) && WEXITSTATUS(status) == ExitUsage)
    throw UsageError(text);  // it has said why
  throw std::runtime_error(text);
}

}  // namespace racebeam
