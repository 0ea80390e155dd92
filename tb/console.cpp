// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/console.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>

#include "tb/output_file.h"

namespace racebeam {

void print(std::string_view text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw OutputError("the standard output", errno, "short write");
}

void tell(std::string_view text) {
  std::fprintf(stderr, "racebeam: %.*s\n", static_cast<int>(text.size()), text.data());
}

bool on_terminal() {
  const char* term = std::getenv("TERM");
  return isatty(STDERR_FILENO) && term && std::string_view(term) != "dumb";
}

bool in_colours() {
  const char* plain = std::getenv("NO_COLOR");
  return on_terminal() && (!plain || std::string_view(plain).empty());
}

}  // namespace racebeam
