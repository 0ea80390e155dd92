// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/tt/tt_chip.h"

#include <filesystem>

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
  const WorkingFolder here(folder);  // $readmemh reads in the first evaluation
  library_.eval();
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
