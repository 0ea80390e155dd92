// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/tt/tt_chip.h"

#include <algorithm>
#include <filesystem>

#include "sc/swap/rtl_remarks.h"
#include "sc/swap/rtl_run.h"
#include "tb/base/console.h"
#include "tb/base/counted.h"
#include "tb/base/errors.h"
#include "tb/base/interrupt.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

const std::vector<rtl_pin>& tile_pins() {
  static const std::vector<rtl_pin> pins = {
      {"ui_in", true, 8},   {"uo_out", false, 8}, {"uio_in", true, 8}, {"uio_out", false, 8},
      {"uio_oe", false, 8}, {"ena", true, 1},     {"clk", true, 1},    {"rst_n", true, 1}};
  return pins;
}

/// Works in another folder for a while.
class WorkingFolder {
 public:
  explicit WorkingFolder(const std::string& folder) : before_(fs::current_path()) {
    fs::current_path(folder);
  }
  ~WorkingFolder() {
    std::error_code ignored;
    fs::current_path(before_, ignored);
  }

 private:
  const fs::path before_;
};

}  // namespace

TtChip::TtChip(const std::string& plugin, const std::string& folder, TilePins inputs)
    : library_(plugin) {
  const std::string faults = port_faults(library_.model(), tile_pins());
  if (!faults.empty())
    throw RtlError(std::string("the module ") + library_.model().unit +
                   " does not fit a Tiny Tapeout tile:" + faults);
  rst_n_ = &pin("rst_n");
  uo_ = &pin("uo_out");
  uio_ = &pin("uio_out");
  oe_ = &pin("uio_oe");
  ui_in_ = &pin("ui_in");
  uio_in_ = &pin("uio_in");
  pin("ena") = 1;
  set_inputs(inputs);
  first_evaluation(folder);
}

// In which $readmemh reads. What is missing is told once, and not as Verilator tells it.
void TtChip::first_evaluation(const std::string& folder) {
  std::vector<std::string> missing;
  {
    const RtlListener listener([&](const std::string& text) {
      const std::string before = "%Warning: ", after = ":0: $readmem file not found";
      const auto end = text.find(after);
      if (text.rfind(before, 0) != 0 || end == std::string::npos) return false;
      const fs::path name = text.substr(before.size(), end - before.size());
      const std::string file = (fs::path(folder) / name).lexically_normal().string();
      if (std::find(missing.begin(), missing.end(), file) == missing.end()) missing.push_back(file);
      return true;
    });
    const WorkingFolder here(folder);
    library_.eval();
  }
  if (missing.empty()) return;
  const std::size_t more = missing.size() - 1;
  tell("warning: " + nearer_path(missing.front()) + " is not there" +
       (more ? ", nor " + counted(more, "more file") + " that the RTL reads"
             : ", which the RTL reads") +
       ": memories keep what they have at the start");
}

void TtChip::set_inputs(TilePins inputs) {
  *ui_in_ = inputs.ui;
  *uio_in_ = inputs.uio;
}

std::uint8_t& TtChip::pin(const char* name) const {
  return *static_cast<std::uint8_t*>(rtl_port_of(library_.model(), name).data);
}

void TtChip::reset(int clocks) {
  *rst_n_ = 0;
  for (; clocks > 0; --clocks) library_.rise();
  *rst_n_ = 1;
  clock_ = 0;
}

void TtChip::run(std::uint64_t clocks, std::vector<PinChange>& changes) {
  constexpr std::uint64_t Look = 8192;  // clocks: then the user may have had enough
  const std::uint64_t begin = clock_;
  for (const std::uint64_t end = clock_ + clocks; clock_ < end; ++clock_) {
    if ((clock_ - begin) % Look == Look - 1 && interrupted()) throw Interrupted();
    const PinChange now{clock_, *uo_, *uio_, *oe_};
    if (now.uo != last_.uo || now.uio != last_.uio || now.oe != last_.oe || clock_ == 0) {
      changes.push_back(now);
      last_ = now;
    }
    library_.rise();
  }
}

}  // namespace racebeam
