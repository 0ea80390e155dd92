// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "tb/base/version.h"
#include "tb/report/html.h"
#include "tb/report/page_files.h"
#include "tb/signoff/mutant_totals.h"
#include "tb/signoff/signoff_report.h"
#include "tb/signoff/signoff_unit.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* Policy =
    "default-src 'none'; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'";
constexpr const char* Words[] = {"good", "bad", "undecided"};
constexpr const char* Colours =
    ".good { color: #116329; } .bad { color: #b3261e; font-weight: 600; }\n"
    ".undecided { color: #7a4f01; font-weight: 600; }\n"
    "@media (prefers-color-scheme: dark) {\n  .good { color: #7ee787; } .bad { color: #ff9a92; }\n"
    "  .undecided { color: #f2cc60; }\n}\n";

HtmlCell verdict_cell(const CheckResult& result) {
  const char* word = Words[result.verdict];
  return {fmt::format("<span class=\"{0}\">{0}</span>", word)};
}

std::string section(const std::string& id, const std::string& title, const std::string& content) {
  return fmt::format(
      "<section id=\"{0}\" aria-labelledby=\"{0}-title\">\n<h2 id=\"{0}-title\">{1}</h2>\n{2}"
      "</section>\n",
      id, html(title), content);
}

std::string overview(const SignoffReport& report) {
  HtmlTable table("overview", "Each check of each unit");
  table.column("unit");
  table.column("check");
  table.column("verdict");
  table.column("what was found");
  table.column("time", "s", "", true);
  for (const CheckResult& result : report.results)
    table.row({{fmt::format("<a href=\"#{0}-{1}\">{0}</a>", html(report.name(result)),
                            html(result.check)),
                "", false, true},
               {html(result.check)},
               verdict_cell(result),
               {html(result.summary), "", false, false, true},
               {fmt::format("{:.1f}", result.seconds), "", true}});
  const std::string all = totals_text(mutant_totals(report.results));
  return table.text() + (all.empty() ? "" : "<p>Mutants of all units: " + html(all) + ".</p>\n");
}

/// A plain figure of a check; those that are lists have a table of their own.
std::string figures(const Json& detail, const std::string& before = "") {
  std::string text;
  for (const auto& [name, value] : detail.items()) {
    std::string label = before + name;
    std::replace(label.begin(), label.end(), '_', ' ');
    if (value.is_object()) text += figures(value, label + ", ");
    else if (!value.is_array())
      text += fmt::format("<dt>{}</dt><dd>{}</dd>\n", html(label),
                          html(value.is_string() ? value.get<std::string>() : value.dump()));
  }
  return text;
}

std::string cell_text(const Json& value) {
  if (value.is_string()) return value;
  if (!value.is_object()) return value.dump();
  std::string text;
  for (const auto& [name, part] : value.items())
    text += (text.empty() ? "" : "; ") + name + ": " + cell_text(part);
  return text;
}

/// A list of a check's detail whose items are objects, as a table with their keys.
std::string list_table(const std::string& id, const std::string& name, const Json& list) {
  std::vector<std::string> keys;
  for (const Json& item : list)
    if (item.is_object())
      for (const auto& entry : item.items())
        if (std::find(keys.begin(), keys.end(), entry.key()) == keys.end())
          keys.push_back(entry.key());
  if (keys.empty()) return "";
  HtmlTable table(id, name);
  for (const std::string& key : keys) table.column(key);
  for (const Json& item : list) {
    std::vector<HtmlCell> cells;
    for (const std::string& key : keys)
      cells.push_back(
          {item.contains(key) ? html(cell_text(item.at(key))) : "", "", false, false, true});
    table.row(cells);
  }
  return table.text();
}

std::string result_section(const CheckResult& result, const std::string& name) {
  const std::string id = html(name + "-" + result.check), title = name + ": " + result.check;
  std::string text = fmt::format("<p><span class=\"{0}\">{0}</span>: {1}.</p>\n",
                                 Words[result.verdict], html(result.summary));
  if (!result.faults.empty()) {
    text += "<ul class=\"sentences\">\n";
    for (const std::string& fault : result.faults) text += "<li>" + html(fault) + "</li>\n";
    text += "</ul>\n";
  }
  if (!result.detail.is_object()) return section(id, title, text);
  text += "<details><summary>Figures</summary>\n<dl>\n" + figures(result.detail) + "</dl>\n";
  for (const auto& [list, value] : result.detail.items())
    if (value.is_array() && !value.empty()) text += list_table(id + "-" + html(list), list, value);
  return section(id, title, text + "</details>\n");
}

std::string method(const SignoffReport& report) {
  std::string text = "<dl>\n";
  for (const SignoffCheck& check : signoff_checks())
    text += fmt::format("<dt>{}</dt><dd>{}</dd>\n", check.name, html(check.meaning));
  return text + "</dl>\n<p>Command: <code>" + html(report.command) + "</code></p>\n";
}

}  // namespace

std::string signoff_page(const SignoffReport& report) {
  const std::string title =
      "Sign-off of " + (report.engine == AllEngines ? "all engines" : report.engine);
  const auto bad =
      std::count_if(report.results.begin(), report.results.end(),
                    [](const CheckResult& result) { return result.verdict != CheckResult::Good; });
  std::string verdict =
      bad == 0 ? "every check is good"
               : fmt::format("{} of {} checks are not good", bad, report.results.size());
  if (!report.whole) verdict += "; interrupted, the other checks were not run";
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n"
      "<title>{} - racebeam</title>\n<style>\n{}{}</style>\n</head>\n<body>\n",
      Policy, html(title), page_file("report.css"), Colours);
  text += fmt::format("<header><h1>{}</h1>\n<p>Scene {}: {}.</p></header>\n<main>\n", html(title),
                      html(report.scene), html(verdict));
  text += section("checks", "All checks", overview(report));
  for (const CheckResult& result : report.results)
    text += result_section(result, report.name(result));
  text += section("method", "How this was checked", method(report));
  return text + fmt::format(
                    "</main>\n<footer><p>Written by racebeam {}.</p></footer>\n</body>\n"
                    "</html>\n",
                    html(program_version()));
}

}  // namespace racebeam
