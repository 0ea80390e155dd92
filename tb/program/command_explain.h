// `racebeam explain`: why a pixel is as it is, down to the clocks that made it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace racebeam {

/// The command line as it was written.
struct ExplainOptions {
  std::string scene;
  long long frame = 0;
  std::string pixel;  ///< "X,Y"
  std::vector<std::string> assignments;
  bool json = false;
};

/// Returns the exit code. Throws UsageError, OutputError.
int command_explain(const ExplainOptions& options);

}  // namespace racebeam
