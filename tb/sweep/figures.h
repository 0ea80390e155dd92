// The figures of a point: one table, whose names sweep files, exports and reports use, and how each
// is read from the stored columns.
//
// Nothing of this is stored, so a better formula needs no new run. The value of a frame is
// (sum of factor * column) / what its kind divides by.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tb/sweep/frame_row.h"
#include "tb/sweep/interval.h"

namespace racebeam {

struct Figure {
  enum Kind {
    Mean,     ///< over frames, of a number of the frame
    PerLine,  ///< over frames, of the frame's number a visible line
    Percent,  ///< over frames, of the share of the frame's visible pixels
    Largest,  ///< of the frames rendered, guard frames too: never extrapolated
    Exact,    ///< of the design, not of frames: given from outside
  };
  struct Term {
    const char* column;
    double factor;
  };

  const char* name;
  const char* unit;
  const char* meaning;  ///< in words
  Kind kind;
  std::vector<Term> terms;

  /// Estimated from frames, with an interval.
  bool sampled() const { return kind == Mean || kind == PerLine || kind == Percent; }
  /// The first of its columns that a store does not have; nullptr if it has all.
  const char* missing(const std::vector<std::string>& columns) const;
};

const std::vector<Figure>& figure_table();
/// nullptr: there is none of that name.
const Figure* figure_named(const std::string& name);

/// Reads a figure from rows whose values stand under `columns`.
class FigureReader {
 public:
  /// Throws UsageError if a column is missing, or the figure is not of frames.
  FigureReader(const Figure& figure, const std::vector<std::string>& columns);

  double value(const FrameRow& row) const;
  /// Of one scene, of which `population` frames may be taken; rows in any order. Guard frames are
  /// kept out of means.
  Stratum stratum(const std::vector<FrameRow>& rows, int population) const;

 private:
  struct Part {
    std::size_t column;
    double factor;
  };
  const Figure& figure_;
  std::vector<Part> parts_;
};

}  // namespace racebeam
