// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/wave/draw_waveform.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "tb/base/console.h"
#include "tb/base/counted.h"
#include "tb/base/errors.h"
#include "tb/base/output_file.h"
#include "tb/wave/wave_file.h"
#include "tb/wave/wave_picture.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

// The words of a register go with it, as when it is traced.
bool takes(const TraceSelection& selection, const std::string& path) {
  const std::string words = "_name";
  const auto stem = path.size() - std::min(path.size(), words.size());
  return selection.takes(path) ||
         (path.substr(stem) == words && selection.takes(path.substr(0, stem)));
}

}  // namespace

void check_picture_name(const std::string& picture) {
  if (extension_of(picture) != ".svg")
    throw UsageError(picture + ": a picture of a waveform ends with .svg");
}

int draw_waveform(const std::string& dump, const std::string& picture,
                  const TraceSelection& selection) {
  if (picture.empty())
    throw UsageError(dump + " is a waveform: --picture FILE.svg draws it, --diff compares two");
  check_picture_name(picture);
  if (is_fst(dump))
    throw UsageError("a picture is drawn of a VCD: `fst2vcd " + dump + " -o " +
                     fs::path(dump).replace_extension(".vcd").string() + "` makes one");
  VcdReader vcd(dump);
  const ClockedWaves waves =
      read_waves(vcd, [&](const std::string& path) { return takes(selection, path); });
  write_text(picture, wave_picture(waves));
  tell(fmt::format("wrote {}: {}, {}", picture, counted(waves.lanes.size(), "signal"),
                   counted(static_cast<std::int64_t>(waves.clocks.size()), "clock")));
  return ExitGood;
}

}  // namespace racebeam
