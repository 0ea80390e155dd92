// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/wave/diff_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "tb/base/console.h"
#include "tb/base/counted.h"
#include "tb/base/errors.h"
#include "tb/wave/vcd_diff.h"

namespace racebeam {

namespace {

constexpr std::size_t ShownRows = 12;

// Names that one file has only, some of them.
void tell_missing(const std::string& file, const std::vector<std::string>& paths) {
  if (paths.empty()) return;
  std::string some;
  for (std::size_t n = 0; n < std::min(paths.size(), ShownRows); ++n) some += "\n  " + paths[n];
  print(fmt::format("only in {}, or of another width: {}{}{}\n", file,
                    counted(paths.size(), "signal"), some,
                    paths.size() > ShownRows ? "\n  ..." : ""));
}

// Where the windows of the files differ.
void tell_windows(const VcdComparison& result, const std::string& a, const std::string& b) {
  if (result.begin_a != result.begin_b)
    print(fmt::format("{} begins at {}, {} at {}: compared from the later one on\n", a,
                      result.begin_a, b, result.begin_b));
  if (!result.end.empty())
    print(
        fmt::format("one file ends at {}, the other goes on: compared up to there\n", result.end));
}

}  // namespace

int report_diff(const std::string& a_path, const std::string& b_path, bool shared_only,
                const TraceSelection& selection) {
  VcdReader a(a_path), b(b_path);
  const VcdComparison result =
      compare_vcds(a, b, [&](const std::string& path) { return selection.takes(path); });
  if (result.shared == 0)
    throw UsageError("the two files have no signal in common, or none under --scope and --depth");
  if (!shared_only) {
    tell_missing(a_path, result.only_a);
    tell_missing(b_path, result.only_b);
  }
  tell_windows(result, a_path, b_path);
  if (result.first) {
    const VcdDifference& d = *result.first;
    print(fmt::format("first difference at {}{}: {}\n", d.time,
                      d.place.empty() ? "" : " (" + d.place + ")",
                      counted(d.rows.size(), "signal")));
    for (std::size_t n = 0; n < std::min(d.rows.size(), ShownRows); ++n)
      print(fmt::format("  {}: {} in {}, {} in {}\n", d.rows[n].path, d.rows[n].a, a_path,
                        d.rows[n].b, b_path));
    return ExitDifference;
  }
  print(fmt::format("{}, {}: no difference\n", counted(result.shared, "shared signal"),
                    counted(result.changes, "change")));
  return shared_only || result.same() ? ExitGood : ExitDifference;
}

}  // namespace racebeam
