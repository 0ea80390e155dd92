// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/provenance.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "tb/base/errors.h"
#include "tb/base/version.h"
#include "tb/base/whole_file.h"
#include "tb/sweep/build_origin.h"
#include "tb/sweep/columns.h"
#include "tb/sweep/model_hash.h"
#include "tb/sweep/row_digest.h"

namespace racebeam {

namespace {

const std::string& program_hash() {
  static const std::string hash = text_hash(whole_file("/proc/self/exe"));
  return hash;
}

std::string program_note(std::int64_t model) {
  return fmt::format("program {} of model {}", program_hash(), model);
}

// The first processor's name.
std::string cpu_name() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (line.rfind("model name", 0) == 0 && line.find(": ") != std::string::npos)
      return line.substr(line.find(": ") + 2);
  return "";
}

std::string host_name() {
  char name[256] = "";
  return gethostname(name, sizeof name - 1) == 0 ? name : "";
}

double seconds(const timeval& time) { return double(time.tv_sec) + 1e-6 * double(time.tv_usec); }

}  // namespace

std::int64_t open_model(Store& store, const SweepPlan& plan, const std::string& folder,
                        bool fresh) {
  const engine& built = plan.scenes.front().show.engine();
  const std::string hash = model_hash(built.name);
  const std::vector<StoredModel> there = store.models();
  const bool known = std::any_of(there.begin(), there.end(),
                                 [&](const StoredModel& one) { return one.hash == hash; });
  if (!known && !there.empty() && !fresh)
    throw UsageError(fmt::format(
        "{} has results of another model, {}; this program's is {}: run with --fresh to keep them "
        "and measure anew, or name another folder with -o",
        folder, there.back().hash, hash));
  return store.model({hash, program_version(), source_commit(), program_hash(), compiler_text()},
                     sweep_columns(built));
}

bool is_new_program(const Store& store, std::int64_t model) {
  return store.notes.find(program_note(model)).empty();
}

void know_program(Store& store, std::int64_t model) {
  store.notes.put(program_note(model), "good");
}

SweepRun this_run(const std::string& command, int cores) {
  return {host_name(), cpu_name(), cores, command,
          fmt::format("racebeam {} {}", program_version(), program_hash())};
}

double cpu_seconds() {
  double sum = 0;
  for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    getrusage(who, &usage);
    sum += seconds(usage.ru_utime) + seconds(usage.ru_stime);
  }
  return sum;
}

}  // namespace racebeam
