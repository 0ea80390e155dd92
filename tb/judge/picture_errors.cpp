#include "tb/judge/picture_errors.h"
namespace racebeam {
knobs reference_knobs(const knobs& k) {
  knobs r;
  r.max_room_depth = 14; r.face_stack_depth = 15; r.interlace = k.interlace; r.dithering = k.dithering;
  r.navigator_bits = k.navigator_bits; r.free_flight = k.free_flight; r.portals_per_face = k.portals_per_face;
  return r;
}
GoldenPicture reference_picture(GoldenTracer tracer, const Show& show, int frame, const knobs& k) {
  return golden_picture(tracer, show.golden_world(frame, reference_knobs(k)), show.golden_camera(frame));
}
int visible_difference(const GoldenPicture& a, const GoldenPicture& reference) { return golden_difference(a, reference); }
}  // namespace racebeam
