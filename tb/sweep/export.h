// A store for other programs, as CSV and JSON. Digests, the picture's too, are 16 digits: JSON's
// numbers have fewer bits.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "tb/base/output_file.h"
#include "tb/sweep/store.h"

namespace racebeam {

// They write all of the file; committing it is the caller's. They throw OutputError and what
// Database throws.

/// One row a point and scene: name, what was set, sample and guard frames, the mean of each column
/// over the sample, and why it failed. Largest and percentile of lines: of frames that have one.
void export_points(Store& store, std::int64_t model, OutputFile& out);
/// One row a frame, with all that was stored of it; nothing where no line had what is asked for.
void export_frames(Store& store, std::int64_t model, OutputFile& out);
/// All models, scenes, points and frames, with histograms, causes, failures and runs; null where no
/// line had what is asked for.
void export_json(Store& store, OutputFile& out);

/// A value of a CSV file: in quotes if need be.
std::string csv_cell(const std::string& text);

}  // namespace racebeam
