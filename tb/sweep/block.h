// Block: what a worker does in one go, and what it answers; both cross a pipe as text, or lie in
// files.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "sc/base/knob_values.h"
#include "tb/sweep/frame_table.h"
#include "tb/sweep/sweep_file.h"

namespace racebeam {

/// Pictures of a frame that a store keeps, packed; "": it has none.
struct KeptPictures {
  std::string reference{};           ///< what the frame is compared with
  std::string end{};                 ///< what its causes lead to, if that is another one
  std::vector<std::string> links{};  ///< as ErrorChain has them
};

/// A point, a scene, and frames of one rung.
struct Block {
  int number = 0;
  int point = 0, scene = 0;  ///< where they stand in the sweep
  std::string scene_name;    ///< as on the command line
  std::string scene_hash;    ///< what the scene must be
  knob_values k;
  knob_values base;  ///< those of the base point
  std::vector<int> frames;
  bool guard = false;
  bool causes = false;    ///< errors by cause are asked for
  bool pictures = false;  ///< the pictures themselves are asked for, and nothing else
  bool scan = false;      ///< only ScannedFrame: busy clocks of the longest line, starved pixels
  SweepReference reference = SweepReference::Geometry;
  std::map<int, KeptPictures> kept{};  ///< by frame; a worker makes those that are not here
  int tries = 0;                       ///< of its first frame
};

std::string request_text(const Block& block);
/// Throws std::exception of what is no request.
Block block_of(const std::string& request);

/// The same without pictures, as JSON: what a plan on disk says of a block.
std::string plan_text_of(const Block& block);
Block block_of_plan(const std::string& text);

/// A frame as a worker answers it.
struct Answer {
  int block = 0;
  MeasuredFrame frame;
  KeptPictures made;    ///< those that the worker had to make
  std::string picture;  ///< packed, if it was asked for; else ""
};

/// One line, as JSON.
std::string answer_line(const Answer& answer);
/// The line after a block's last.
std::string done_line(int block);
/// A worker that cannot go on says so instead.
std::string error_line(int block, const std::string& error);

struct AnswerLine {
  enum Kind { Frame, Done, Error, Garbage };
  Kind kind = Garbage;
  Answer answer{};
  std::string error{};
};
/// What a line of a worker of this block says.
AnswerLine read_answer(const std::string& line, int block);

}  // namespace racebeam
