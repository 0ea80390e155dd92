// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_machine.h"

namespace racebeam {

block_machine::block_machine(const block_knobs& k)
    : knobs_(k), store_(k.store(), block_knobs::clocks_per_pixel) {}

void block_machine::draw(const block_tables& tables) {
  constexpr int StartClocks = 1;
  const int sent = host_clocks(tables.balls.size());
  store_.go_to(store_.clock() + sent + StartClocks, nullptr);

  const std::int64_t start = store_.clock();
  store_counters stored;
  block_renderer renderer(knobs_, converted(tables, knobs_));
  renderer.note(notes_);
  renderer.draw([&](std::int64_t clock, const block_word& word) {
    store_.go_to(start + clock, &stored);
    return store_.offer(word.address, word.pixels, stored);
  });
  counters_ = renderer.counters();
  const std::int64_t end = start + static_cast<std::int64_t>(counters_.clocks);
  store_.go_to(end, &stored);
  stored.store_reads = store_.reads_before(end) - store_.reads_before(start);
  static_cast<store_counters&>(counters_) = stored;
  counters_.frames = store_.frames_before(end) - store_.frames_before(start);
  if (notes_) {
    for (block_renderer::dealt& block : notes_->blocks) block.clock += start;
    for (std::int64_t& clock : notes_->begins) clock += start;
  }
  counters_.host_clocks = static_cast<std::uint64_t>(sent);
}

}  // namespace racebeam
