// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/making_line.h"

#include <cstdio>

#include "tb/base/console.h"

namespace racebeam {

MakingLine::MakingLine(const std::string& text) : text_(text), moves_(watched()) {
  if (!moves_) tell(text_);
}

MakingLine::~MakingLine() {
  if (moves_) std::fputs("\r\x1b[K", stderr);
}

std::function<void()> MakingLine::tick() const {
  return [this] {
    if (!moves_) return;
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    std::fprintf(stderr, "\r\x1b[K%s  %.1f s", text_.c_str(), elapsed.count());
  };
}

}  // namespace racebeam
