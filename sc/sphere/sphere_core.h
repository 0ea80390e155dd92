// sphere_core: the sphere tracer with its frame store in one loop, without SystemC: the base of the
// tlm level. The same words, clocks and counters as sphere_chip.
//
// A picture is: HOST, clock by clock, until the table is loaded, and then all its pixels at once.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sc/sphere/first_hit.h"
#include "sc/sphere/sphere_host_link_core.h"
#include "sc/sphere/sphere_rays.h"
#include "sc/store/frame_store.h"

namespace racebeam {

/// A stay in a state, for `explain`.
struct sphere_step {
  int state;
  int clocks;
  int object;          ///< -1: none
  std::string what;    ///< what came of it, if anything
  std::uint64_t word;  ///< after ADD: what the pixel is so far; after NEXT: what it is; else 0
};

class sphere_core {
 public:
  /// After a reset with these switches and keys. `tables` must outlive it.
  sphere_core(const sphere_knobs& k, const sphere_tables& tables, const sphere_board& board);
  sphere_core(const sphere_core&) = delete;

  /// In HOST: a clock; whether it was the last one of HOST.
  bool host_clock(const sphere_host_pins& cpu);
  /// While the tracer is busy: what the CPU does to its wires in a clock; faults count for the next
  /// picture.
  void busy_clock(const sphere_host_pins& cpu);
  /// In HOST: what a CPU does that sends these spheres, two clocks a sphere, to the end of HOST.
  void load(const std::vector<sphere_row>& spheres);
  /// In HOST: on to the next frame of the raster in whose first clock the write buffer is empty,
  /// and the frame store is made black (back door).
  void await_frame() { store_.await_frame(); }
  /// In HOST: KEY3 is pressed and let go, with the board like this; the raster goes on.
  void reset(const sphere_board& board);
  /// In HOST: eye, light, screen and modes become these (back door).
  void deposit(const sphere_inputs_core& inputs);
  /// From now on the clocks in which pixels begin go there, row by row; nullptr: nowhere.
  void note_pixels(std::vector<std::int64_t>* begins) { begins_ = begins; }
  /// Draws the picture; the board as it is at its end.
  void draw(const sphere_board& board) {
    draw();
    finish(board);
  }
  /// The same in two steps: up to its last clock; what switches and keys do at its end.
  void draw();
  void finish(const sphere_board& board);
  /// Of the picture drawn last, and of HOST before it.
  const sphere_counters& counters() const { return counters_; }

  /// The frame store, when all words of the picture are in it, by address.
  std::vector<std::uint64_t> picture() const { return store_.picture(); }
  int address(int x, int y) const { return y << (knobs_.wide ? 10 : 9) | x; }
  int columns() const { return knobs_.columns(drawn_narrow_); }  ///< of that picture
  int rows() const { return knobs_.rows(drawn_narrow_); }
  const frame_store& store() const { return store_; }
  const sphere_inputs_core& inputs() const { return inputs_; }
  const sphere_table_core& table() const { return table_; }

  /// What a pixel shows, sphere_first_hit, with eye, light, modes and table as they are now.
  int first_hit(int x, int y) const;
  /// What a pixel takes, no wait for the write buffer among it, with eye, light, modes and table as
  /// they are now.
  std::vector<sphere_step> explain(int x, int y) const;

 private:
  const sphere_knobs knobs_;
  const sphere_tables& tables_;
  sphere_inputs_core inputs_;
  sphere_host_link_core link_;
  sphere_table_core table_;
  sphere_rays rays_;
  frame_store store_;
  sphere_counters counters_;
  sphere_counters host_;  // of the HOST that is on
  bool drawn_narrow_ = false;
  std::vector<std::int64_t>* begins_ = nullptr;
};

}  // namespace racebeam
