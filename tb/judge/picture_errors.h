// temporary
#pragma once
#include "tb/golden/golden_picture.h"
#include "tb/judge/golden_compare.h"
#include "tb/show/show.h"
namespace racebeam {
knobs reference_knobs(const knobs& k);
GoldenPicture reference_picture(GoldenTracer tracer, const Show& show, int frame, const knobs& k);
int visible_difference(const GoldenPicture& a, const GoldenPicture& reference);
}  // namespace racebeam
