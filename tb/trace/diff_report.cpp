// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/trace/diff_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "tb/console.h"
#include "tb/counted.h"
#include "tb/errors.h"
#include "tb/trace/vcd_diff.h"

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

}  // namespace

int report_diff(const std::string& a_path, const std::string& b_path, bool shared_only) {
  VcdReader a(a_path), b(b_path);
  const VcdComparison result = compare_vcds(a, b);
  if (result.shared == 0) throw UsageError("the two files have no signal in common");
  if (!shared_only) {
    tell_missing(a_path, result.only_a);
    tell_missing(b_path, result.only_b);
  }
  if (result.first) {
    const VcdDifference& d = *result.first;
    print(fmt::format("first difference at {} ps{}: {}\n", d.time,
                      d.place.empty() ? "" : " (" + d.place + ")",
                      counted(d.rows.size(), "signal")));
    for (std::size_t n = 0; n < std::min(d.rows.size(), ShownRows); ++n)
      print(fmt::format("  {}: {} in {}, {} in {}\n", d.rows[n].path,
                        d.rows[n].a.empty() ? "unknown" : d.rows[n].a, a_path,
                        d.rows[n].b.empty() ? "unknown" : d.rows[n].b, b_path));
    return ExitDifference;
  }
  const bool same = shared_only || result.same();
  print(fmt::format("{}, {}: no difference\n", counted(result.shared, "shared signal"),
                    counted(result.changes, "change")));
  return same ? ExitGood : ExitDifference;
}

}  // namespace racebeam
