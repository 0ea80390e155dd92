// Who waits for whom in the block renderer's chip.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "sc/block/block_chip.h"
#include "sc/block/engine.h"
#include "tb/bench/picture_waits.h"
#include "tb/twin/engine_raster.h"

namespace racebeam {

namespace {

class BlockWaits final : public PictureWaits {
 public:
  BlockWaits(const block_chip& chip, const knob_values& k)
      : PictureWaits(chip, k,
                     static_cast<std::uint64_t>(raster_of(block_engine(), k).line_clocks())),
        chip_(chip) {}

 private:
  void look() override {
    const bool busy = chip_.busy.read() != 0, ready = chip_.job_ready.read() != 0;
    const bool asks = chip_.word_valid.read() != 0, served = chip_.bus_valid.read();
    unserved_.see(asks && !served);
    // While the buffer takes words, the one that is served is to hear of it.
    unanswered_.see(asks && served && chip_.put_ready.read() && chip_.word_ready.read() == 0);
    converting_.see(chip_.valid_i->read() && !chip_.ready_o->read());
    undealt_.see(!busy && ready && chip_.job_valid.read() == 0 && !chip_.done_o->read());
    unready_.see(!busy && !ready && !chip_.done_o->read());
    busy_.see(busy);
  }

  std::vector<Wait> tracer() const override {
    if (converting_ >= Told)
      return {{"the host", "block_convert.ready_o = 1", converting_.clocks},
              {"block_convert", "", converting_.clocks, "valid_i is 1, and ready_o stays 0"}};
    std::vector<Wait> links = {{"write_buffer", "block_bus.bus_valid_o = 1"}};
    if (unserved_ >= Told || unanswered_ >= Told) {
      links.push_back({"block_bus", "", unserved_ >= Told ? unserved_.clocks : unanswered_.clocks,
                       unserved_ >= Told
                           ? "word_valid_i asks, and bus_valid_o is 0"
                           : "the word of a core is taken, and word_ready_o stays 0"});
      return links;
    }
    links.push_back({"block_bus", "block_core.word_valid_o = 1"});
    if (undealt_ >= Told) {
      links.push_back({"block_core", "block_scheduler.job_valid_o = 1", undealt_.clocks});
      links.push_back(
          {"block_scheduler", "", undealt_.clocks, "cores are ready, and none gets a job"});
    } else if (unready_ >= Told) {
      links.push_back(
          {"block_core", "", unready_.clocks, "it has no job (busy_o = 0), and takes none"});
    } else if (busy_ >= Told) {
      std::string states;
      for (const auto& place : chip_.g_core)
        states += fmt::format(" {}", static_cast<int>(place->state.read().to_uint()));
      links.push_back({"block_core", "", busy_.clocks,
                       fmt::format("it has a job (busy_o = 1), and offers {}; states{}",
                                   repeats() ? "the same word for ever" : "no word", states)});
    } else {
      links.push_back({"block_core", "block_scheduler.done_o = 0"});
      links.push_back({"block_scheduler", "", 0, "the picture does not begin, or does not end"});
    }
    return links;
  }

  const block_chip& chip_;
  Held unserved_, unanswered_, converting_, undealt_, unready_, busy_;
};

}  // namespace

std::unique_ptr<WaitWatch> make_block_waits(const wired_chip& chip, const knob_values& k,
                                            const LastRises&) {
  return std::make_unique<BlockWaits>(static_cast<const block_chip&>(chip), k);
}

}  // namespace racebeam
