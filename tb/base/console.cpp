// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/base/console.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>

#include "tb/base/output_file.h"

namespace racebeam {

namespace {

[[noreturn]] void throw_error(int error) {
  if (error == EPIPE) throw ClosedPipe("the standard output", error, "");
  throw OutputError("the standard output", error, "short write");
}

std::FILE* results = stdout;

bool is_set(const char* name) {
  const char* value = std::getenv(name);
  return value && *value;
}

}  // namespace

// A closed stdout or stderr stays closed.
void keep_stdout() {
  const int kept = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3);
  std::FILE* const file = kept < 0 ? nullptr : fdopen(kept, "w");
  if (!file) return;
  results = file;
  if (dup2(STDERR_FILENO, STDOUT_FILENO) < 0) close(STDOUT_FILENO);
  setvbuf(stdout, nullptr, _IOLBF, 0);
}

void give_back_stdout() {
  if (results != stdout) dup2(fileno(results), STDOUT_FILENO);
}

int stdout_file() { return fileno(results); }

void print(std::string_view text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), results) != text.size() || std::fflush(results) != 0)
    throw_error(errno);
}

void tell(std::string_view text) {
  std::fprintf(stderr, "racebeam: %.*s\n", static_cast<int>(text.size()), text.data());
}

bool on_terminal() {
  return isatty(STDERR_FILENO) && is_set("TERM") && std::getenv("TERM") != std::string_view("dumb");
}

bool in_colours() { return on_terminal() && !is_set("NO_COLOR"); }

bool watched() { return on_terminal() && !is_set("CI"); }

}  // namespace racebeam
