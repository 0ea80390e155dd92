// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/report_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "tb/base/counted.h"
#include "tb/base/version.h"
#include "tb/report/html.h"
#include "tb/report/page_files.h"
#include "tb/report/report_method.h"
#include "tb/report/report_tables.h"
#include "tb/sweep/interval_text.h"

namespace racebeam {

namespace {

constexpr const char* Policy =
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data:; "
    "base-uri 'none'; form-action 'none'";

/// The pictures of the base and the front have so much in any case.
constexpr std::size_t LeastRoom = 1'000'000;
constexpr std::size_t AroundPicture = 300;

std::string chart(const char* id, const char* label, const char* controls = "") {
  return fmt::format(
      "<div class=\"controls scripted\">{2}</div>\n"
      "<div class=\"chart scripted\" id=\"{0}\" role=\"group\" aria-label=\"{1}\"></div>\n",
      id, label, controls);
}

std::string absent(const std::string& why) {
  return "<p class=\"absent\">Not shown: " + html(why) + ".</p>\n";
}

std::string section(const char* id, const char* title, const std::string& content) {
  return fmt::format(
      "<section id=\"{0}\" aria-labelledby=\"{0}-title\">\n<h2 id=\"{0}-title\">{1}</h2>\n{2}"
      "</section>\n",
      id, title, content);
}

std::string list_of(const std::vector<std::string>& sentences) {
  std::string text = "<ul class=\"sentences\">\n";
  for (const std::string& one : sentences) text += "<li>" + html(one) + "</li>\n";
  return text + "</ul>\n";
}

std::string header(const ReportedSweep& sweep) {
  std::vector<std::string> facts;
  for (std::size_t scene = 0; scene < sweep.plan.scenes.size(); ++scene)
    facts.push_back(
        fmt::format("{}, {} of {} frames", html(sweep.plan.scenes[scene].name),
                    grouped(sweep.plan.sample(scene)),
                    grouped(static_cast<long long>(sweep.plan.scenes[scene].order.size()))));
  facts.push_back(counted(sweep.points.size(), "point"));
  if (sweep.model.id != 0)
    facts.push_back(fmt::format("racebeam {}, model {}", html(sweep.model.version),
                                html(sweep.model.hash.substr(0, 8))));
  return fmt::format("<header><h1>{}</h1>\n<p>{}</p></header>\n", html(sweep.name),
                     fmt::join(facts, " &middot; "));
}

std::string front_section(const ReportedSweep& sweep) {
  const std::string table = front_table(sweep);
  if (table.empty()) return section("front", "Front", absent("no point is measured yet"));
  return section("front", sweep.plan.file.goals.empty() ? "Points" : "Front",
                 "<div class=\"beside\"><div>" +
                     chart("front-chart", "Points by two figures, with their intervals",
                           "<label>across <select id=\"front-x\"></select></label> "
                           "<label>up <select id=\"front-y\"></select></label>") +
                     table +
                     "</div><aside id=\"look\" class=\"scripted\" aria-live=\"polite\" "
                     "aria-label=\"The point that was chosen\"></aside></div>\n" +
                     "<p class=\"note scripted\">A point under the mouse shows its picture; a "
                     "click on it, or on "
                     "its name in the table of all points, puts it beside the base.</p>\n" +
                     scenes_table(sweep));
}

std::string knobs_sections(const ReportedSweep& sweep, const ReportParts& parts) {
  if (sweep.knobs.empty() || sweep.measured() < 2) {
    const std::string why = "there is no second point that is measured";
    return section("parallel", "All knobs at once", absent(why)) +
           section("sensitivity", "What each knob does", absent(why)) +
           section("heat", "Two knobs together", absent(why));
  }
  std::string text = section(
      "parallel", "All knobs at once",
      chart("parallel-chart", "Parallel coordinates: a line for each point",
            "<span id=\"picked\" role=\"status\"></span> "
            "<button type=\"button\" id=\"all-points\">all points</button>") +
          "<p class=\"note scripted\">Drag along an axis: the charts and the table follow.</p>\n");
  const std::string table = effects_table(sweep, parts);
  text += section(
      "sensitivity", "What each knob does",
      table.empty() ? absent("no two points differ in one knob alone")
                    : chart("effects-chart", "The change by each step of a knob, with its interval",
                            "<label>figure <select id=\"effects-figure\"></select></label>") +
                          (has_steps(sweep)
                               ? "<p class=\"note\">Pairs of points that differ in this knob "
                                 "alone, on the same frames, with intervals of 95 %; left out are "
                                 "pairs of which one stopped "
                                 "earlier than others.</p>\n"
                               : "<p class=\"note\">Points that a search has chosen: means over "
                                 "points, whose other knobs differ too. A search that looks for a "
                                 "front does not spread them evenly.</p>\n") +
                          table);
  return text +
         section("heat", "Two knobs together",
                 sweep.knobs.size() < 2
                     ? absent("one knob varies; a heat map has two")
                     : chart("heat-chart", "A figure by two knobs",
                             "<label>across <select id=\"heat-x\"></select></label> "
                             "<label>up <select id=\"heat-y\"></select></label> "
                             "<label>figure <select id=\"heat-figure\"></select></label>") +
                           "<p class=\"note\">Each field: the mean over the points that "
                           "have both values. The table of all points has the numbers.</p>\n");
}

std::string focus_note(const ReportParts& parts) {
  if (parts.front_left_out == 0) return "";
  return fmt::format("<p class=\"note\">{} more of the front left out here.</p>\n",
                     counted(parts.front_left_out, "point"));
}

std::string parts_sections(const ReportedSweep& sweep, const ReportParts& parts) {
  const std::string units = units_table(sweep, parts), slack = slack_table(sweep, parts),
                    causes = causes_table(sweep, parts);
  return section("units", "What it costs, by unit",
                 units.empty()
                     ? absent(sweep.no_units.empty() ? "no point of the front has its units"
                                                     : sweep.no_units)
                     : chart("units-chart", "Cells by unit, stacked") + focus_note(parts) + units) +
         section("slack", "Slack",
                 slack.empty()
                     ? absent("there is no histogram of slack of these points")
                     : chart("slack-chart", "How long before they are shown pixels are known") +
                           "<p class=\"note\">Clocks from known to shown; pixels that are known "
                           "too late are not in it.</p>\n" +
                           focus_note(parts) + slack) +
         section("causes", "Errors by cause",
                 causes.empty()
                     ? absent(sweep.plan.file.measure.causes
                                  ? "no pixel differs from the reference picture"
                                  : "the sweep does not measure them: [measure] causes = true does")
                     : chart("causes-chart", "Pixels that differ, by cause, stacked") +
                           focus_note(parts) + causes);
}

std::string pictures_section(const ReportedSweep& sweep, const ReportPictures& pictures) {
  if (pictures.taken.empty())
    return section("pictures", "Pictures",
                   absent("the sweep keeps none: [measure] pictures = [7223, \"worst\"] does"));
  std::string front, others;
  for (std::size_t at = 0; at < pictures.taken.size(); ++at) {
    const ReportPicture& picture = pictures.taken[at];
    const ReportedPoint& point = sweep.points[picture.point];
    const std::string frame =
        fmt::format("frame {} of {}{}", picture.frame, html(sweep.plan.scenes[picture.scene].name),
                    picture.why.empty() ? "" : ", its " + html(picture.why));
    std::string& to = picture.point == 0 || point.on_front() ? front : others;
    to += fmt::format(
        "<figure><img id=\"picture-{}\" width=\"320\" height=\"240\" alt=\"{} as {} draws it\" "
        "src=\"data:image/png;base64,{}\"><figcaption>{}: {}</figcaption></figure>\n",
        at, frame, html(point.name), picture.base64, html(point.name), frame);
  }
  std::string text = "<div class=\"pictures\">" + front + "</div>\n";
  if (!others.empty())
    text += "<details><summary>Pictures of the other points</summary><div class=\"pictures\">" +
            others + "</div></details>\n";
  if (pictures.left_out > 0)
    text += fmt::format(
        "<p class=\"note\">{} left out, for the page to stay small; the commands of "
        "the points draw them.</p>\n",
        counted(pictures.left_out, "picture"));
  return section("pictures", "Pictures", text);
}

std::string script(std::string_view text) { return fmt::format("<script>\n{}\n</script>\n", text); }

std::string licences() {
  std::string text = "<details><summary>Licences of what draws the charts</summary>\n";
  for (const char* of : {"vega", "vega-lite", "vega-embed", "d3"})
    text += fmt::format("<h3>{}</h3><pre tabindex=\"0\">{}</pre>\n", of,
                        html(std::string(page_file(std::string("vega/LICENSE.") + of))));
  return text + "</details>\n";
}

}  // namespace

std::string report_page(const SweepReader& reader) {
  const ReportedSweep& sweep = reader.sweep();
  const ReportParts parts = report_parts(reader);
  const std::string head = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n"
      "<title>{} - racebeam</title>\n<style>\n{}</style>\n</head>\n<body>\n",
      Policy, html(sweep.name), page_file("report.css"));
  const std::string before =
      header(sweep) + "<main>\n" +
      "<noscript><p class=\"note\">Without a script there are no charts; the tables have the same "
      "numbers.</p></noscript>\n" +
      section("says", "What it says", list_of(report_sentences(sweep, parts))) +
      front_section(sweep) + knobs_sections(sweep, parts) + parts_sections(sweep, parts);
  const auto behind = [&](const ReportPictures& pictures) {
    const std::string points =
        "<div class=\"controls scripted\"><label>only points with these names or words "
        "<input id=\"only\" type=\"search\"></label></div>\n" +
        points_table(sweep, pictures);
    return section("points", "All points",
                   sweep.points.empty() ? absent("no point has been begun") : points) +
           section("method", "How this was measured", report_method(sweep)) + "</main>\n<footer>" +
           fmt::format("<p>Written by racebeam {}.</p>", html(program_version())) + licences() +
           "</footer>\n<script type=\"application/json\" id=\"data\">" +
           json_in_html(report_data(sweep, parts, pictures)) + "</script>\n" +
           script(page_file("vega/vega.min.js")) + script(page_file("vega/vega-lite.min.js")) +
           script(page_file("vega/vega-embed.min.js")) + script(page_file("report.js")) +
           "</body>\n</html>\n";
  };
  const std::size_t without =
      head.size() + before.size() + behind({}).size() + AroundPicture * sweep.points.size();
  const ReportPictures pictures =
      report_pictures(sweep, reader.folder(),
                      ReportBytes > without + LeastRoom ? ReportBytes - without : LeastRoom);
  return head + before + pictures_section(sweep, pictures) + behind(pictures);
}

}  // namespace racebeam
