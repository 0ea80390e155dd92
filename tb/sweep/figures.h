// The figures of a point: one table, whose names sweep files, exports and reports use, and how each
// is read from the stored columns.
//
// Nothing of this is stored, so a better formula needs no new run. The value of a frame is
// (sum of factor * column) / (the sum of other columns, or what its kind divides by).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sc/base/engine.h"
#include "tb/sweep/frame_row.h"
#include "tb/sweep/interval.h"

namespace racebeam {

struct PointFigure {
  enum Kind {
    Mean,     ///< over frames, of a number of the frame
    PerLine,  ///< over frames, of the frame's number a visible line
    Percent,  ///< over frames, of the share of the frame's visible pixels
    Frames,   ///< the share of frames in which the number is not 0, in %
    Largest,  ///< of the frames rendered, guard frames too: never extrapolated
    Exact,    ///< of the design, not of frames: given from outside
  };
  struct Term {
    std::string column;
    double factor;
  };

  std::string name;
  const char* unit;
  std::string meaning;  ///< in words
  Kind kind;
  std::vector<Term> terms;
  std::vector<Term> per = {};  ///< what a frame's number is divided by; empty: as its kind says
  bool of_cause = false;       ///< its column is an ErrorCause, not one of frames
  const char* tool = "";       ///< the key of [measure] that brings an Exact one; "": the model

  /// Estimated from frames, with an interval.
  bool sampled() const { return kind != Largest && kind != Exact; }
  /// The key of [measure] that brings it: "silicon", "causes", or "".
  const char* measure() const { return of_cause ? "causes" : tool; }
  /// What is read of a frame.
  std::vector<std::string> columns() const;
  /// Whether an engine has all that it is read from.
  bool is_of(const engine& built) const;
  /// The first of its columns that a store does not have; nullptr if it has all.
  const char* missing(const std::vector<std::string>& columns) const;
};

const std::vector<PointFigure>& figure_table();
/// Those of an engine that have them: a name may mean another formula of another engine.
std::vector<const engine*> engines_with(const PointFigure& figure);
/// nullptr: there is none of that name.
const PointFigure* figure_named(const std::string& name);
/// The same of an engine.
const PointFigure* figure_named(const std::string& name, const engine& built);
/// One line of the table in docs/explore.md, without the newline.
std::string figure_row(const PointFigure& figure);
/// All of them for a terminal, one a line, each after `before`.
std::string figures_text(const std::string& before = "");

/// Reads a figure from rows whose values stand under `columns`.
class FigureReader {
 public:
  /// Throws UsageError if a column is missing, or the figure is not of frames.
  FigureReader(const PointFigure& figure, const std::vector<std::string>& columns);

  double value(const FrameRow& row) const;
  /// Of one scene, of which `population` frames may be taken; rows in any order. Guard frames are
  /// kept out of means.
  Stratum stratum(const std::vector<FrameRow>& rows, int population) const;

 private:
  struct Part {
    std::size_t column;
    double factor;
  };
  static std::vector<Part> parts(const std::vector<PointFigure::Term>& terms,
                                 const std::vector<std::string>& columns, double divisor);

  const PointFigure& figure_;
  std::vector<Part> parts_, per_;
};

}  // namespace racebeam
