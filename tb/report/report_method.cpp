// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/report_method.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tb/base/counted.h"
#include "tb/report/html.h"
#include "tb/sweep/interval_text.h"

namespace racebeam {

namespace {

std::string item(const std::string& term, const std::string& content) {
  return content.empty() ? "" : "<dt>" + html(term) + "</dt><dd>" + content + "</dd>\n";
}

std::string frames_text(const ReportedSweep& sweep) {
  const SweepPlan& plan = sweep.plan;
  std::string text;
  for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
    const SweepScene& of = plan.scenes[scene];
    const auto taken = of.order.begin() + plan.sample(scene);
    text += fmt::format(
        "<details><summary>{}: {} of {} frames</summary><p>In this order, each point the first of "
        "them; as <code>--at</code> of <code>racebeam render</code> takes them:</p>"
        "<p><code>{}</code></p></details>",
        html(of.name), grouped(plan.sample(scene)),
        grouped(static_cast<long long>(of.order.size())), fmt::join(of.order.begin(), taken, ","));
  }
  if (plan.left_out > 0)
    text += fmt::format("{} frames of parts that match {} are left out. ", grouped(plan.left_out),
                        html(fmt::format("{}", fmt::join(plan.file.frames.skip, ", "))));
  if (plan.file.frames.guard > 0)
    text += fmt::format(
        "{} guard frames, the worst of the base, are beside them: for largest values, "
        "not for means.",
        plan.file.frames.guard);
  return text;
}

std::string scenes_text(const ReportedSweep& sweep) {
  std::string text;
  for (const SweepScene& scene : sweep.plan.scenes)
    text += fmt::format("{}{} <code>{}</code>", text.empty() ? "" : ", ", html(scene.name),
                        html(scene.show.hash()));
  return text;
}

std::string runs_table(const ReportedSweep& sweep) {
  if (sweep.runs.empty()) return "";
  HtmlTable table("runs-table", "Runs");
  for (const char* name : {"started", "ended", "machine", "CPU time", "program", "command"})
    table.column(name);
  for (const SweepRun& run : sweep.runs)
    table.row({{html(run.started)},
               {run.ended.empty() ? "not told" : html(run.ended)},
               {html(fmt::format("{}, {}, {} at once", run.host, run.cpu, run.cores))},
               {fmt::format("{:.1f} s", run.cpu_seconds)},
               {html(run.tools)},
               {"<code>" + html(run.command) + "</code>"}});
  return table.text();
}

}  // namespace

std::string report_method(const ReportedSweep& sweep) {
  const SweepFile& file = sweep.plan.file;
  const auto method = static_cast<std::size_t>(file.search.method);
  const auto reference = static_cast<std::size_t>(file.measure.reference);
  const std::string version =
      sweep.model.id == 0
          ? ""
          : fmt::format("racebeam {}, commit <code>{}</code>, program <code>{}</code>, {}",
                        html(sweep.model.version), html(sweep.model.commit),
                        html(sweep.model.program), html(sweep.model.compiler));
  return "<dl>\n" + item("state", html(sweep.state)) + item("scenes", scenes_text(sweep)) +
         item("frames", frames_text(sweep)) +
         item("search", fmt::format("{}, seed {}{}", method_words()[method], file.search.seed,
                                    file.search.race && !file.goals.empty()
                                        ? "; points that are surely dominated stop early"
                                        : "")) +
         item("reference picture", reference_words()[reference]) +
         item(
             "intervals",
             "of 95 %, from the successive differences of the frames in order, with Student's t; "
             "changes are of the same frames. &quot;So far&quot;: fewer than 256 frames. A largest "
             "value has no interval. Cells are exact, without wires; one or two more or less say "
             "nothing.") +
         item("model", sweep.model.id == 0 ? "" : "<code>" + html(sweep.model.hash) + "</code>") +
         item("measured by", version) + item("synthesis", html(sweep.yosys)) + "</dl>\n" +
         runs_table(sweep) + "<h3>The sweep file</h3>\n<pre tabindex=\"0\">" +
         html(sweep.plan.text) + "</pre>\n";
}

}  // namespace racebeam
