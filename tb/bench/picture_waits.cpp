// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/picture_waits.h"

namespace racebeam {

PictureWaits::PictureWaits(const picture_chip& chip, const knob_values& k,
                           std::uint64_t line_clocks)
    : store_(chip),
      two_lines_(2 * line_clocks),
      depth_(static_cast<std::uint64_t>(k.of("write_buffer_depth"))) {}

void PictureWaits::clock() {
  const bool take = store_.take_valid.read(), ready = store_.take_ready.read();
  const bool put = store_.u_write_buffer->put_valid_i->read();
  refused_.see(take && !ready);
  line_.see(!store_.line_end.read());
  full_.see(!store_.put_ready.read() && !take);
  reads_.see(store_.read.read());
  offered_.see(put);
  takes_ = put ? 0 : takes_ + (take && ready);
  look();
}

std::vector<Wait> PictureWaits::chain() const {
  if (line_ >= two_lines_)
    return {{"store_arbiter", "vga_timing.line_end_o = 1", line_.clocks},
            {"vga_timing", "", line_.clocks, "its lines do not go on"}};
  // It may have to wait for a line's end.
  if (refused_ >= two_lines_) {
    const Wait refused = {"write_buffer", "store_arbiter.take_ready_o = 1", refused_.clocks};
    if (reads_ >= two_lines_)
      return {refused,
              {"store_arbiter", "frame_scanout.read_o = 0", reads_.clocks},
              {"frame_scanout", "", reads_.clocks, "it reads in every clock"}};
    return {
        refused,
        {"store_arbiter", "", refused_.clocks, "it refuses the word on offer (take_valid_i = 1)"}};
  }
  if (full_ >= Told)
    return {{"write_buffer", "", full_.clocks,
             "it takes nothing (put_ready_o = 0), and offers nothing (take_valid_o = 0)"}};
  if (takes_ > 2 * depth_)
    return {{"write_buffer", "", takes_, "it offers more words than were put into it"}};
  return tracer();
}

}  // namespace racebeam
