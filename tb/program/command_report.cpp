// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/command_report.h"

#include <fmt/format.h>

#include "tb/base/console.h"
#include "tb/base/counted.h"
#include "tb/base/errors.h"
#include "tb/base/output_file.h"
#include "tb/program/common_options.h"
#include "tb/report/report_page.h"

namespace racebeam {

namespace {

struct Options {
  std::string folder, output;
};

void add_options(const CommandOptions& command, Options& options) {
  command.add_option("folder", options.folder, "Folder of a sweep, finished or not")
      .required()
      .type_name("DIR")
      .check(not_empty);
  command.add_option("-o,--output", options.output, "The page; default: DIR/report.html")
      .type_name("FILE.html")
      .check(not_empty);
}

int run_report(const Options& options) {
  const SweepReader reader(options.folder);
  const std::string file =
      options.output.empty() ? reader.folder().file("report.html") : options.output;
  const std::string page = report_page(reader);
  write_text(file, page);
  print(fmt::format("{}: {}, {:.1f} MB; open it in a browser\n", file,
                    counted(reader.sweep().points.size(), "point"), double(page.size()) / 1e6));
  return ExitGood;
}

}  // namespace

Command report_row() {
  return make_command<Options>("report", "Write a sweep as a page to look at", "Measure",
                               "report out/stack -o stack.html", add_options, run_report);
}

}  // namespace racebeam
