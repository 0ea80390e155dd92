// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/sphere_core.h"

namespace racebeam {

sphere_core::sphere_core(const sphere_knobs& k, const sphere_tables& tables,
                         const sphere_board& board)
    : knobs_(k.resolved()),
      tables_(tables),
      rays_(knobs_, table_, tables.planes, inputs_),
      store_(knobs_.store(), knobs_.clocks_per_pixel) {
  reset(board);
}

bool sphere_core::host_clock(const sphere_host_pins& cpu) {
  const bool loaded = link_.loaded_q;
  table_.clock(link_.write_q, knobs_);
  link_.clock({true, cpu, inputs_.light_q, inputs_.scene_q, true}, knobs_);
  host_.host_faults += link_.fault_q;
  ++host_.host_clocks;
  store_.go_to(store_.clock() + 1, nullptr);
  return loaded;
}

void sphere_core::busy_clock(const sphere_host_pins& cpu) {
  link_.clock({true, cpu, inputs_.light_q, inputs_.scene_q, false}, knobs_);
  host_.host_faults += link_.fault_q;
}

void sphere_core::load(const std::vector<sphere_row>& spheres) {
  const int number = static_cast<int>(spheres.size());
  sphere_host_pins cpu;
  for (int n = 0; n <= number; ++n) {
    if (n < number) {
      const sphere_row& s = spheres[static_cast<std::size_t>(n)];
      cpu = {number << 4 | n, s.color_word(), s.centre[0], s.centre[1], s.centre[2],
             s.reflect,       s.radius,       s.radius2,   s.inverse,   true};
    }
    cpu.sphere = number << 4 | (n < number ? n : 0);
    cpu.valid = true;
    host_clock(cpu);
    cpu.valid = false;
    if (host_clock(cpu)) return;
  }
}

void sphere_core::reset(const sphere_board& board) {
  inputs_.clock({false, board.sw, board.key_n, false}, tables_.start);
  link_ = {};
  drawn_narrow_ = inputs_.narrow_q;
}

void sphere_core::deposit(const sphere_inputs_core& inputs) {
  inputs_ = inputs;
  drawn_narrow_ = inputs_.narrow_q;
}

void sphere_core::draw() {
  sphere_counters& n = counters_;
  n = host_;
  host_ = {};
  drawn_narrow_ = inputs_.narrow_q;
  const std::int64_t start = store_.clock();
  for (int y = 0; y < rows(); ++y)
    for (int x = 0; x < columns(); ++x) {
      const std::int64_t begin = store_.clock();
      if (begins_) begins_->push_back(begin);
      const int put_to = address(x, y);
      rays_.pixel(x, y, no_sphere_log{}, [&](int clock, std::uint64_t word) {
        store_.go_to(begin + clock, &n);
        return store_.put(put_to, word, n);
      });
    }
  n.state_clocks[SphereHost] = n.host_clocks;
  rays_.take(n);
  n.frames = store_.frames_before(store_.clock()) - store_.frames_before(start);
  n.store_reads = store_.reads_before(store_.clock()) - store_.reads_before(start);
}

void sphere_core::finish(const sphere_board& board) {
  inputs_.clock({true, board.sw, board.key_n, true}, tables_.start);
}

int sphere_core::first_hit(int x, int y) const {
  int hit = MeetsNothing;
  bool known = false;
  sphere_rays rays(knobs_, table_, tables_.planes, inputs_);
  const auto log = [&](int state, int, int object, const char* what) {
    if (known) return;
    const bool nearest = *what == 'n';
    if (state == SphereAlong && *what) hit = EyeInside;
    else if (state == SphereHit && nearest) hit = object;
    else if (state == SpherePlaneT && nearest) hit = FirstPlane + object;
    known = state == SphereLight || state == SphereLray || state == SphereNext;
  };
  rays.pixel(x, y, log, [](int, std::uint64_t) { return 0; });
  return hit;
}

std::vector<sphere_step> sphere_core::explain(int x, int y) const {
  std::vector<sphere_step> steps;
  std::uint64_t offered = 0;
  sphere_rays rays(knobs_, table_, tables_.planes, inputs_);
  const auto log = [&](int state, int clocks, int object, const char* what) {
    steps.push_back({state, clocks, object, what, 0});
    if (state == SphereAdd) steps.back().word = rays.so_far();
    if (state == SphereNext) steps.back().word = offered;
  };
  rays.pixel(x, y, log, [&](int, std::uint64_t word) {
    offered = word;
    return 0;
  });
  return steps;
}

}  // namespace racebeam
