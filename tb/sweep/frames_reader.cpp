// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/frames_reader.h"

#include <algorithm>
#include <string>

#include "tb/scene/table_reader.h"
#include "tb/sweep/sweep_keys.h"

namespace racebeam {

namespace {

void read_sample(const TomlNode& node, int& to, Faults& faults) {
  int number = 0;
  if (node.kind == TomlNode::String) {
    if (read_word(node, "sample", {"all"}, number, faults)) to = 0;
  } else {
    read_number(node, "sample", 1, MaxFrames, to, faults, "frames of each point, or \"all\"");
  }
}

void read_skip(const TomlNode& node, std::vector<std::string>& to, Faults& faults) {
  if (node.kind != TomlNode::Array) {
    wrong_type(node, "skip", "a list of patterns, [\"*ray pattern*\"]", faults);
    return;
  }
  to.clear();
  for (const TomlNode& item : node.items)
    if (std::string pattern; read_text(item, "skip", pattern, faults)) to.push_back(pattern);
}

}  // namespace

void read_frames(const TomlNode& node, const std::vector<SweepFigure>& figures, SweepFrames& frames,
                 Faults& faults) {
  const TableReader table(node, "frames", faults, sweep_keys());
  const TomlNode* sample = table.find("sample");
  if (sample) read_sample(*sample, frames.sample, faults);
  if (const TomlNode* skip = table.find("skip")) read_skip(*skip, frames.skip, faults);
  table.read("guard", 0, MaxFrames, frames.guard);
  const TomlNode* until = table.find("until");
  if (until) frames.until = read_until(*until, figures, faults);
  if (!table.read("most", 1, MaxFrames, frames.most)) {
    frames.most = std::max(frames.most, frames.sample);
  } else if (frames.most < frames.sample) {
    faults.add(table.find("most")->place,
               "'most' is " + std::to_string(frames.most) + " and 'sample' is " +
                   std::to_string(frames.sample),
               "'most' is where 'until' stops: at least 'sample'");
  }
  if (until && frames.sample == 0)
    faults.warn(until->place, "'until' has no effect: the sample is all frames",
                "all frames leave no interval");
}

}  // namespace racebeam
