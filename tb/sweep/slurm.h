// Slurm, as far as a sweep needs it: an array of tasks, and what the queue knows of them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace racebeam {

/// What the queue says of a task.
enum class TaskState { Live, Cancelled, Ended };

/// "0-2,5" of sorted numbers.
std::string ranges_text(const std::vector<int>& numbers);
/// The newest job's word on each of so many tasks, of lines "JOB TASK STATE"; others are skipped.
/// The task N/A is all that a job never began: cancelled, it has no line for each.
std::map<int, TaskState> task_states(const std::string& lines, int tasks);
/// One word for a shell.
std::string shell_quoted(const std::string& word);

class Slurm {
 public:
  /// Throws MissingTool if there is no sbatch.
  Slurm();

  /// So many tasks an array may have.
  int largest_array() const;

  struct Job {
    std::string name;
    std::vector<int> tasks;
    std::string log;      ///< %a is the task
    std::string command;  ///< for a shell; $SLURM_ARRAY_TASK_ID is the task
    int minutes = 10;     ///< that a task may take
    std::string options;  ///< of the user, between blanks
  };
  /// Its number; nothing, with `why`, if Slurm does not take it.
  std::optional<std::string> submit(const Job& job, std::string& why) const;

  /// Of all jobs of this name that it remembers; nothing, with `why`, if it does not answer.
  std::optional<std::map<int, TaskState>> states(const std::string& name, int tasks,
                                                 std::string& why) const;
};

}  // namespace racebeam
