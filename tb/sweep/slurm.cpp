// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/slurm.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <filesystem>
#include <sstream>

#include "tb/base/errors.h"
#include "tb/verilate/run_tool.h"

namespace racebeam {

namespace {

constexpr std::chrono::seconds Patience(60);  // with a controller that is away
constexpr int UsualArray = 1001;              // MaxArraySize, if nobody says another one

ToolResult run(std::vector<std::string> words) {
  ToolRun tool;
  tool.words = std::move(words);
  ToolResult result{};
  run_tools({tool}, 1, Patience, [&result](std::size_t, const ToolResult& end) { result = end; });
  if (result.late) result.said = tool.words[0] + " did not answer in time";
  while (!result.said.empty() && std::isspace(static_cast<unsigned char>(result.said.back())))
    result.said.pop_back();
  return result;
}

TaskState state_of(const std::string& word) {
  static constexpr std::array Ended = {"COMPLETED",     "FAILED",    "TIMEOUT",  "NODE_FAIL",
                                       "OUT_OF_MEMORY", "BOOT_FAIL", "DEADLINE", "REVOKED"};
  if (word.rfind("CANCELLED", 0) == 0) return TaskState::Cancelled;
  const bool ended =
      std::any_of(Ended.begin(), Ended.end(), [&word](const char* one) { return word == one; });
  return ended ? TaskState::Ended : TaskState::Live;
}

}  // namespace

std::string ranges_text(const std::vector<int>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t end = i + 1;
    while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1) ++end;
    text += (text.empty() ? "" : ",") + std::to_string(numbers[i]);
    if (end - i > 1) text += "-" + std::to_string(numbers[end - 1]);
    i = end;
  }
  return text;
}

std::map<int, TaskState> task_states(const std::string& lines, int tasks) {
  struct Word {
    long job = 0;
    TaskState state = TaskState::Ended;
  };
  std::map<int, Word> newest;
  Word never_begun;
  std::istringstream in(lines);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    long job = 0;
    std::string task, state;
    if (!(words >> job >> task >> state)) continue;
    const bool all = task == "N/A";
    if (!all && task.find_first_not_of("0123456789") != std::string::npos) continue;
    Word& word = all ? never_begun : newest[std::stoi(task)];
    if (word.job <= job) word = {job, state_of(state)};
  }
  std::map<int, TaskState> states;
  for (const auto& [task, word] : newest) states[task] = word.state;
  if (never_begun.state != TaskState::Cancelled) return states;
  for (int task = 0; task < tasks; ++task) {
    const auto at = newest.find(task);
    if (at == newest.end() ||
        (at->second.state != TaskState::Live && at->second.job < never_begun.job))
      states[task] = TaskState::Cancelled;
  }
  return states;
}

std::string shell_quoted(const std::string& word) {
  const bool plain = std::all_of(word.begin(), word.end(), [](unsigned char c) {
    return std::isalnum(c) || c == '/' || c == '.' || c == '_' || c == '-' || c == '+';
  });
  if (plain && !word.empty()) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

Slurm::Slurm() {
  if (!has_tool("sbatch"))
    throw MissingTool(
        "sbatch is not installed; without it: racebeam sweep run ... --jobs N, or --on hand for "
        "another queue");
}

int Slurm::largest_array() const {
  const ToolResult said = run({"scontrol", "show", "config"});
  std::istringstream lines(said.said);
  for (std::string name, sign; lines >> name;) {
    int size = 0;
    if (name == "MaxArraySize" && lines >> sign >> size && size > 0) return size;
  }
  return UsualArray;
}

std::optional<std::string> Slurm::submit(const Job& job, std::string& why) const {
  std::vector<std::string> words = {"sbatch", "--parsable", "--requeue",
                                    fmt::format("--time={}", job.minutes)};
  std::istringstream options(job.options);
  for (std::string word; options >> word;) words.push_back(word);
  for (const std::string& own :
       {"--job-name=" + job.name, "--array=" + ranges_text(job.tasks),
        std::string("--open-mode=append"), "--chdir=" + std::filesystem::current_path().string(),
        "--output=" + job.log, "--wrap=" + job.command})
    words.push_back(own);
  const ToolResult result = run(words);
  if (!result.good) {
    why = "sbatch: " + result.said;
    return {};
  }
  const std::string last = result.said.substr(result.said.rfind('\n') + 1);
  return last.substr(0, last.find(';'));
}

std::optional<std::map<int, TaskState>> Slurm::states(const std::string& name, int tasks,
                                                      std::string& why) const {
  const ToolResult result =
      run({"squeue", "-h", "-r", "--me", "-t", "all", "--name=" + name, "-o", "%F %K %T"});
  if (result.good) return task_states(result.said, tasks);
  why = "squeue: " + result.said;
  return {};
}

}  // namespace racebeam
