// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/console.h"

#include <cerrno>
#include <cstdio>

#include "tb/output_file.h"

namespace racebeam {

namespace {

[[noreturn]] void throw_error(int error) {
  if (error == EPIPE) throw ClosedPipe("the standard output", error, "");
  throw OutputError("the standard output", error, "short write");
}

}  // namespace

void print(std::string_view text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw_error(errno);
}

void tell(std::string_view text) {
  std::fprintf(stderr, "racebeam: %.*s\n", static_cast<int>(text.size()), text.data());
}

}  // namespace racebeam
