// The program's commands with their options, as its help has them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace racebeam {

/// An option, or an argument, which has no names.
struct OptionText {
  std::vector<std::string> names;  ///< -o, --output
  std::string shown, values;       ///< the entry of the help: names, and what stands behind them
  std::string help;                ///< what it is for
  std::string type;                ///< of its values: FILE
  int least_values, most_values;   ///< each time that it is given
  bool is_help;                    ///< --help, which all commands have
};

struct CommandText {
  std::string name, summary;
  std::string footer;  ///< of its help
  std::vector<OptionText> options;
  std::vector<CommandText> commands;  ///< that it has
};

}  // namespace racebeam
