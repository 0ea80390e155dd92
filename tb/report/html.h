// HTML from texts of any kind.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace racebeam {

/// As text, and as a value in quotes: whatever is in it, it ends neither. Bytes that are no UTF-8,
/// and control characters, become U+FFFD.
std::string html(const std::string& text);

/// JSON that may stand in a <script>: no "<" is left in it.
std::string json_in_html(std::string json);

struct HtmlCell {
  std::string content;         ///< HTML
  std::string sorted_by = "";  ///< a number, or a text; "": by its text
  bool number = false;         ///< to the right
  bool head = false;           ///< of its row
  bool words = false;          ///< a text of any length
};

/// A table with a caption, in a box that scrolls if it is too wide.
class HtmlTable {
 public:
  HtmlTable(const std::string& id, const std::string& caption) : id_(id), caption_(caption) {}

  /// `meaning` is told by the column's title.
  void column(const std::string& name, const std::string& unit = "",
              const std::string& meaning = "", bool number = false);
  void row(const std::vector<HtmlCell>& cells, const std::string& attributes = "");
  std::string text() const;

 private:
  const std::string id_, caption_;
  std::string head_{}, body_{};
};

}  // namespace racebeam
