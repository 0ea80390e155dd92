// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/html.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace racebeam {

namespace {

constexpr const char* Replacement = "\xef\xbf\xbd";

std::string valid(const std::string& text) {
  using nlohmann::json;
  if (std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; }))
    return text;
  return json::parse(json(text).dump(-1, ' ', false, json::error_handler_t::replace))
      .get<std::string>();
}

}  // namespace

std::string html(const std::string& text) {
  std::string result;
  for (const char c : valid(text)) switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      case '"': result += "&quot;"; break;
      case '\'': result += "&#39;"; break;
      default:
        const auto code = static_cast<unsigned char>(c);
        if ((code < ' ' && c != '\n' && c != '\t') || code == 0x7f) result += Replacement;
        else result += c;
    }
  return result;
}

std::string json_in_html(std::string json) {
  for (std::size_t at = 0; (at = json.find('<', at)) != std::string::npos; at += 6)
    json.replace(at, 1, "\\u003c");
  return json;
}

void HtmlTable::column(const std::string& name, const std::string& unit, const std::string& meaning,
                       bool number) {
  head_ += fmt::format("<th scope=\"col\"{}{}>{}{}</th>", number ? " class=\"number\"" : "",
                       meaning.empty() ? "" : " title=\"" + html(meaning) + "\"", html(name),
                       unit.empty() ? "" : " <small>" + html(unit) + "</small>");
}

void HtmlTable::row(const std::vector<HtmlCell>& cells, const std::string& attributes) {
  body_ += "<tr" + attributes + ">";
  for (const HtmlCell& cell : cells)
    body_ += fmt::format("<{0}{1}{2}>{3}</{4}>", cell.head ? "th scope=\"row\"" : "td",
                         cell.number  ? " class=\"number\""
                         : cell.words ? " class=\"words\""
                                      : "",
                         cell.sorted_by.empty() ? "" : " data-by=\"" + html(cell.sorted_by) + "\"",
                         cell.content, cell.head ? "th" : "td");
  body_ += "</tr>\n";
}

std::string HtmlTable::text() const {
  return fmt::format(
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{1}\"><table id=\"{0}\">"
      "<caption>{1}</caption>\n<thead><tr>{2}</tr></thead>\n<tbody>\n{3}</tbody></table></div>\n",
      id_, html(caption_), head_, body_);
}

}  // namespace racebeam
