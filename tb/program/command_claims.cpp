// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/command_claims.h"

#include <algorithm>
#include <thread>

#include "sc/beam/engine.h"
#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/base/interrupt.h"
#include "tb/base/output_file.h"
#include "tb/program/common_options.h"
#include "tb/report/claim_golden.h"
#include "tb/report/claim_report.h"
#include "tb/report/claims.h"
#include "tb/show/set_knob.h"
#include "tb/sweep/worker.h"

namespace racebeam {

namespace {

constexpr int MostFrames = 16'383;

struct Options {
  ClaimSetting setting;
  std::string frames = "256";
  std::vector<std::string> only;
  std::string markdown;
  bool json = false;
};

std::string is_frames(const std::string& word) {
  return word == "all" ? "" : is_number("--frames", "1..16383, or all")(word);
}

int frames_of(const std::string& word) {
  if (word == "all") return 0;
  const int frames = word.size() > 5 ? 0 : std::stoi(word);
  if (frames < 1 || frames > MostFrames)
    throw UsageError("--frames " + word + " is out of range; 1..16383, or all");
  return frames;
}

int run_claims(Options& options) {
  ForkServer frames(work_on), golden(answer_golden);  // while this process is small
  options.setting.frames = frames_of(options.frames);
  knob_values base = beam_engine().standard(nullptr);
  set_knobs(beam_engine(), base, options.setting.base);
  const std::vector<Claim> all = load_claims();
  const std::vector<Claim> chosen = chosen_claims(all, options.only);
  make_folder(options.setting.folder);
  catch_interrupts();
  const auto findings = measure_claims(chosen, all, options.setting, {frames, golden});
  if (!findings) {
    tell("interrupted; what was measured is kept; the same command goes on");
    return ExitInterrupted;
  }
  if (!options.markdown.empty()) write_text(options.markdown, claims_markdown(*findings));
  print(options.json ? claims_json(*findings, options.setting.frames) : claims_text(*findings));
  const bool differs = std::any_of(findings->begin(), findings->end(), [](const auto& finding) {
    return finding.verdict() == ClaimVerdict::DoesNotHold;
  });
  return differs ? ExitDifference : ExitGood;
}

void add_options(const CommandOptions& command, Options& options) {
  ClaimSetting& setting = options.setting;
  setting.folder = "racebeam_claims";
  setting.jobs = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  command
      .add_option("--only", options.only,
                  "Measure this claim alone, by its row S0-62 or 62 of the seed's inventory "
                  "(repeatable)")
      .type_name("ROW")
      .repeatable();
  command
      .add_option("--frames", options.frames, "Frames of each chip, spread over the scene, or all")
      .type_name("N|all")
      .check(is_frames)
      .capture_default_str();
  command
      .add_option("-o,--output", setting.folder,
                  "Folder: what is measured is kept there, and found")
      .type_name("DIR")
      .check(not_empty)
      .capture_default_str();
  add_number(command, "--jobs", setting.jobs, "Workers at once; default: the cores",
             is_number_in("--jobs", 1, 256));
  command
      .add_option("--set", setting.base,
                  "Another chip than the taped-out one, to see which claims notice (repeatable)")
      .type_name("KNOB=VALUE")
      .repeatable();
  command.add_flag("--fresh", setting.fresh,
                   "With another model measure anew; the old results are kept");
  command.add_flag("--json", options.json, "JSON on stdout instead of the text");
  command.add_option("--markdown", options.markdown, "The table as Markdown")
      .type_name("FILE.md")
      .check(not_empty);
}

}  // namespace

Command claims_row() {
  return {"claims", "Measure what the article says of the chip", "Measure",
          "claims --only 62 --frames 64", [](const CommandOptions& command) -> RunCommand {
            const auto options = std::make_shared<Options>();
            add_options(command, *options);
            return [options](const std::vector<std::string>& words) {
              for (const std::string& word : words)
                options->setting.command += (options->setting.command.empty() ? "" : " ") + word;
              return run_claims(*options);
            };
          }};
}

}  // namespace racebeam
