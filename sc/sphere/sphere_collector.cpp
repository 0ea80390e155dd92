// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/sphere_collector.h"

#include "sc/sphere/numbers.h"

namespace racebeam {

void sphere_collector::count_state(const sphere_view& v) {
  sphere_counters& n = now_;
  ++n.clocks;
  ++n.state_clocks[static_cast<std::size_t>(v.state == SphereReflectTwo ? SphereReflect : v.state)];
  switch (v.state) {
    case SphereRay:
    case SphereLray:
      ++(v.state == SphereLray ? n.shadow_rays : v.direct ? n.primary_rays : n.reflected_rays);
      n.overflows += length_overflows(v.sum);
      ++n.roots;
      n.divisions += 3;
      break;
    case SphereCentre:
    case SphereShadowAlong: ++n.sphere_tests; break;
    case SpherePlane: ++n.plane_tests; break;
    case SpherePlaneD: ++n.divisions; break;
    case SphereWait:
      ++n.hits;
      ++n.roots;
      break;
    case SphereShadowFront:
    case SphereShadowChord:
    case SpherePlaneT: n.shadowed += v.shader_op == ShadeHalf; break;
    case SphereAdd: ++n.passes; break;
    case SphereNext: n.black_inside += state_ == SphereAlong; break;
    default: break;
  }
}

void sphere_collector::observe(const sphere_view& v) {
  sphere_counters& n = now_;
  // A fault is told in the clock after; what happens while a picture is drawn is of the next one.
  if (v.fault) ++(state_ == SphereHost ? n.host_faults : late_faults_);
  if (v.state == SphereHost) {
    ++n.host_clocks;
    ++n.state_clocks[SphereHost];
  } else {
    count_state(v);
    n.frames += frame_begins_;
    count(v.store, store_knobs_, n);
  }
  frame_begins_ = v.store.frame_end;
  state_ = v.state;
  if (!v.picture_done) return;
  last_ = n;
  n = {};
  n.host_faults = late_faults_;
  late_faults_ = 0;
  ++pictures_;
}

}  // namespace racebeam
