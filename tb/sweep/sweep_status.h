// What a sweep's folder says of itself: how far it is, and whether it is sound.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace racebeam {

/// How far a sweep is, who works on it, what failed; as JSON if `json`. Throws UsageError of a
/// folder that is none.
std::string status_text(const std::string& folder, bool json);
/// Whether somebody works on it.
bool is_running(const std::string& folder);

/// Reads the whole store, and measures so many stored frames anew: whatever is not as it must be is
/// in the report. True: nothing. Throws UsageError of a folder that is none.
bool check_sweep(const std::string& folder, int sample, int jobs, std::string& report);

enum class ExportKind { Points, Frames, Json };
/// Writes the results of this program's model, or else of the last one.
void export_sweep(const std::string& folder, ExportKind kind, const std::string& file);

}  // namespace racebeam
