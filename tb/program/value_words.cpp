// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/value_words.h"

#include <functional>
#include <map>
#include <set>

#include "tb/explain/figures.h"
#include "tb/explain/glossary.h"
#include "tb/golden/golden_picture.h"
#include "tb/program/command_bench.h"
#include "tb/program/completion_script.h"
#include "tb/render/render_options.h"
#include "tb/scene/engines.h"
#include "tb/show/level.h"
#include "tb/show/open_show.h"
#include "tb/trace/beam_trigger.h"
#include "tb/trace/trace_options.h"
#include "tb/twin/channels.h"
#include "tb/twin/use_option.h"
#include "tb/view/frame_maps.h"

namespace racebeam {

namespace {

using Words = std::vector<std::string>;

template <class Table, class Name>
Words words_of(const Table& table, const Name& name) {
  Words words;
  for (const auto& row : table) words.emplace_back(name(row));
  return words;
}

Words with(Words words, const std::string& more) {
  words.push_back(more);
  return words;
}

Words units() {
  Words names;
  for (const engine* one : engines())
    for (const unit_row& row : one->units) names.emplace_back(row.name);
  return with(names, AllUnits);
}

Words knob_names() {
  std::set<std::string> names;
  for (const engine* one : engines())
    for (const knob_row& row : one->knobs)
      if (!row.of_scene) names.insert(row.name);
  return {names.begin(), names.end()};
}

/// "block.cores"
Words knob_names_by_engine() {
  Words names;
  for (const engine* one : engines())
    for (const knob_row& row : one->knobs)
      if (!row.of_scene) names.push_back(std::string(one->name) + "." + row.name);
  return names;
}

Words values_of_knob(const std::string& name) {
  for (const engine* one : engines())
    for (const knob_row& row : one->knobs)
      if (row.name == name) return row.names;
  return {};
}

ValueWords only(Words words) { return {std::move(words), ValueWords::None}; }

/// The names before `=`, and what `values` may follow one.
Words assignments(const Words& names, const std::string& text,
                  const std::function<Words(const std::string& name)>& values) {
  const auto equals = text.find('=');
  if (equals == std::string::npos)
    return words_of(names, [](const std::string& name) { return name + "="; });
  const std::string name = text.substr(0, equals);
  return words_of(values(name), [&](const std::string& value) { return name + "=" + value; });
}

ValueWords own_rtl(const std::string& text) {
  if (text.find('=') != std::string::npos) return {{}, ValueWords::Files};
  Words words = units();
  for (const engine* one : engines())
    if (*one->top) words.emplace_back(one->top);
  return only(words);
}

ValueWords implementations(const std::string& text) {
  const auto comma = text.rfind(',') + 1;  // 0: none
  const std::string before = text.substr(0, comma), last = text.substr(comma);
  const Words words =
      assignments(units(), last, [](const std::string&) { return own_implementations(); });
  return {words_of(words, [&](const std::string& word) { return before + word; }),
          last.find('=') == std::string::npos ? ValueWords::None : ValueWords::Files};
}

ValueWords maps(const std::string& text) {
  const std::string before = text.substr(0, text.rfind(',') + 1);
  return only(words_of(MapKinds, [&](const MapKind& kind) { return before + map_name(kind); }));
}

using WordsOf = std::function<ValueWords(const std::string& text)>;

WordsOf always(Words (*words)()) {
  return [words](const std::string&) { return only(words()); };
}

const std::map<std::string, WordsOf>& table() {
  static const std::map<std::string, WordsOf> rows = {
      {"KNOB=VALUE",
       [](const std::string& text) {
         return only(assignments(knob_names(), text, values_of_knob));
       }},
      {"ENGINE.KNOB=VALUE",
       [](const std::string& text) {
         return only(assignments(knob_names_by_engine(), text, [](const std::string& name) {
           return values_of_knob(name.substr(name.find('.') + 1));
         }));
       }},
      {"LEVEL", always([] {
         return Words{LevelTlm, LevelSignal};
       })},
      {"CHANNEL", always(channel_names)},
      {"ENGINE",
       always([] { return words_of(engines(), [](const engine* one) { return one->name; }); })},
      {"MAP", maps},
      {"NAME",
       always([] { return words_of(figures(), [](const Figure& one) { return one.name; }); })},
      {"ROW", always(bench_rows)},
      {"SCENE",
       [](const std::string&) {
         return ValueWords{scene_names(), ValueWords::Files};
       }},
      {"SHELL", always(completion_shells)},
      {"TRACER", always([] { return with(golden_tracer_names(), Compare); })},
      {"TRIGGER", always([] { return with(trigger_names(), Mismatch); })},
      {"UNIT", own_rtl},
      {"UNIT=IMPLEMENTATION", implementations},
      {"WHAT", always([] {
         return Words{ShowPicture, ShowHits};
       })},
      {"WORD",
       always([] { return words_of(glossary(), [](const Word& one) { return one.word; }); })},
  };
  return rows;
}

}  // namespace

ValueWords value_words(const std::string& type, const std::string& text) {
  if (const auto row = table().find(type); row != table().end()) return row->second(text);
  if (type == "DIR") return {{}, ValueWords::Folders};
  const bool path = type == "PATH" || type.find("FILE") != std::string::npos ||
                    (type.find('.') != std::string::npos && type.find("..") == std::string::npos);
  return {{}, path ? ValueWords::Files : ValueWords::None};
}

std::vector<std::string> types_with_words() {
  return words_of(table(), [](const auto& row) { return row.first; });
}

}  // namespace racebeam
