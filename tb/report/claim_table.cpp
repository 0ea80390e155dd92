// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/claim_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <set>

#include "sc/beam/engine.h"
#include "tb/base/counted.h"
#include "tb/base/errors.h"
#include "tb/base/nearest.h"
#include "tb/base/project_folder.h"
#include "tb/base/whole_file.h"
#include "tb/report/claim_figures.h"
#include "tb/scene/table_reader.h"
#include "tb/show/open_show.h"
#include "tb/sweep/knob_reader.h"
#include "tb/sweep/sweep_point.h"

namespace racebeam {

namespace {

constexpr double Infinity = std::numeric_limits<double>::infinity();

const std::vector<FileKey>& claim_keys() {
  static const std::vector<FileKey> keys = {
      {"", "claim", "tables", "required", "a claim; repeatable"},
      {"claim", "id", "text", "required", "rows of the seed's inventory"},
      {"claim", "says", "text", "required", "the claim in a sentence"},
      {"claim", "why", "text", "none", "what is different where it does not plainly hold"},
      {"claim", "check", "tables", "required", "a figure and its bounds; repeatable"},
      {"check", "how", "text", "required", "what is measured, in words"},
      {"check", "figure", "name", "required", "what is measured"},
      {"check", "per", "name", "none", "a figure that it is divided by"},
      {"check", "scene", "demo or a scene's name", "demo", "where"},
      {"check", "of", "table of knobs", "the chip", "which chip"},
      {"check", "against", "table of knobs", "the chip", "which chip it is compared with"},
      {"check", "as", "value, difference, change", "value", "change: in % of the other chip's"},
      {"check", "times", "number", "1", "what the value is multiplied with"},
      {"check", "unit", "text", "none", "behind the number"},
      {"check", "expected", "text", "required", "what the seed leads to expect"},
      {"check", "holds", "[from, to]", "required", "bounds within which it holds"},
      {"check", "in_kind", "[from, to]", "none", "wider ones: holds in kind"},
  };
  return keys;
}

/// A text of any length.
void read_sentence(const TableReader& table, const std::string& key, const char* help,
                   std::string& to) {
  const TomlNode* node = help ? table.require(key, help) : table.find(key);
  if (!node) return;
  if (node->kind != TomlNode::String) return wrong_type(*node, key, "a text", table.faults());
  if (node->text.empty())
    table.faults().add(node->place, "'" + key + "' is empty", "write a sentence");
  to = node->text;
}

bool read_bounds(const TomlNode& node, const std::string& key, ClaimBounds& to, Faults& faults) {
  if (node.kind != TomlNode::Array || node.items.size() != 2) {
    wrong_type(node, key, "two numbers, [from, to]", faults);
    return false;
  }
  const auto read = [&](const TomlNode& item, double& number) {
    if (item.kind == TomlNode::Float && std::isinf(item.number)) number = item.number;
    else return read_decimal(item, key, -Infinity, Infinity, number, faults);
    return true;
  };
  if (!read(node.items[0], to.from) || !read(node.items[1], to.to)) return false;
  if (to.from <= to.to) return true;
  faults.add(node.place, "'" + key + "' begins behind its end", "write [from, to]");
  return false;
}

/// "name=value" of each knob.
void read_side(const TomlNode& node, std::vector<std::string>& to, Faults& faults) {
  SweepPoint point{"", beam_engine().standard(nullptr)};
  read_point_knobs(node, point, faults);
  for (const knob_row* row : point.set)
    to.push_back(fmt::format("{}={}", row->name, row->text(point.value_of(*row))));
}

void read_figure(const TableReader& table, const std::string& key, std::string& to) {
  if (!table.read(key, to) || claim_source(to)) return;
  table.faults().add(table.find(key)->place, "unknown figure " + racebeam::quoted(to),
                     name_help(to, claim_figure_names()));
}

ClaimCheck read_check(const TomlNode& node, Faults& faults) {
  const TableReader table(node, "check", faults, claim_keys());
  ClaimCheck check;
  check.place = node.place;
  if (node.kind != TomlNode::Table) return check;
  read_sentence(table, "how", "what is measured: how = \"restarts a line\"", check.how);
  table.require("figure", "what is measured: figure = \"restarts\"");
  read_figure(table, "figure", check.figure);
  read_figure(table, "per", check.per);
  table.read("scene", check.scene);
  if (const TomlNode* scene = table.find("scene"); scene && check.scene != "demo")
    if (const auto names = scene_names();
        std::find(names.begin(), names.end(), check.scene) == names.end())
      faults.add(scene->place, "there is no scene " + racebeam::quoted(check.scene),
                 name_help(check.scene, names));
  if (const TomlNode* of = table.find("of")) read_side(*of, check.of, faults);
  const TomlNode* const against = table.find("against");
  if (against) read_side(*against, check.against, faults);
  int as = check.as;
  table.read_choice("as", {"value", "difference", "change"}, as);
  check.as = static_cast<ClaimCheck::As>(as);
  if ((against != nullptr) != (check.as != ClaimCheck::Value))
    faults.add(node.place, "'against' goes with 'as' alone",
               "write both, as = \"difference\" or \"change\", or none of them");
  table.read("times", -1e9, 1e9, check.times);
  table.read("unit", check.unit);
  read_sentence(table, "expected", "what the seed leads to expect", check.expected);
  if (const TomlNode* holds = table.require("holds", "the bounds: holds = [0, 1]"))
    read_bounds(*holds, "holds", check.holds, faults);
  if (const TomlNode* kind = table.find("in_kind")) {
    ClaimBounds wider;
    if (read_bounds(*kind, "in_kind", wider, faults)) {
      if (wider.from > check.holds.from || wider.to < check.holds.to)
        faults.add(kind->place, "'in_kind' does not enclose 'holds'", "make it wider");
      check.in_kind = wider;
    }
  }
  return check;
}

Claim read_claim(const TomlNode& node, std::set<std::string>& ids, Faults& faults) {
  const TableReader table(node, "claim", faults, claim_keys());
  Claim claim;
  if (node.kind != TomlNode::Table) return claim;
  table.require("id", "rows of the seed's inventory: id = \"S0-62\"");
  if (table.read("id", claim.id) && !ids.insert(claim.id).second)
    faults.add(table.find("id")->place,
               "the claim " + racebeam::quoted(claim.id) + " is there twice",
               "give one of them more checks");
  read_sentence(table, "says", "the claim: says = \"...\"", claim.says);
  read_sentence(table, "why", nullptr, claim.why);
  const TomlNode* checks = table.require("check", "written below a line [[claim.check]]");
  if (!checks) return claim;
  if (checks->kind != TomlNode::Array)
    wrong_type(*checks, "check", "written below a line [[claim.check]]", faults);
  for (const TomlNode& check : checks->items) claim.checks.push_back(read_check(check, faults));
  return claim;
}

/// "S0-62, 63": "62", "63".
std::vector<std::string> numbers_of(const std::string& id) {
  std::vector<std::string> all(1);
  for (const char c : id)
    if (c == ',') all.emplace_back();
    else if (c != ' ') all.back() += c;
  for (std::string& one : all) one.erase(0, one.find('-') + 1);
  return all;
}

}  // namespace

ClaimsResult read_claims(std::string_view text) {
  ClaimsResult result;
  const std::optional<TomlNode> root = parse_toml(text, result.faults);
  if (!root) return result;
  const TableReader top(*root, "", result.faults, claim_keys());
  const TomlNode* claims = top.require("claim", "written below a line [[claim]]");
  if (!claims) return result;
  if (claims->kind != TomlNode::Array)
    wrong_type(*claims, "claim", "written below a line [[claim]]", result.faults);
  std::set<std::string> ids;
  for (const TomlNode& claim : claims->items)
    result.claims.push_back(read_claim(claim, ids, result.faults));
  return result;
}

std::vector<Claim> load_claims() {
  const std::string path = project_folder() + "/tb/report/claims.toml";
  if (!std::filesystem::exists(path))
    throw MissingTool("there is no " + path + ": install racebeam with its table of claims");
  ClaimsResult result = read_claims(whole_file(path));
  if (result.faults.none()) return result.claims;
  std::fputs(result.faults.text(path).c_str(), stderr);
  throw UsageError(counted(result.faults.count(), "fault") + " in " + path);
}

std::vector<Claim> chosen_claims(const std::vector<Claim>& all,
                                 const std::vector<std::string>& ids) {
  if (ids.empty()) return all;
  std::vector<bool> chosen(all.size());
  for (const std::string& id : ids) {
    bool found = false;
    std::vector<std::string> known;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::vector<std::string> numbers = numbers_of(all[i].id);
      const bool is_it = std::any_of(numbers.begin(), numbers.end(), [&](const std::string& n) {
        return id == n || id == "S0-" + n;
      });
      if (is_it || id == all[i].id) chosen[i] = found = true;
      for (const std::string& number : numbers) known.push_back("S0-" + number);
    }
    if (!found) {
      const std::string meant = nearest(id, known);
      throw UsageError("there is no claim " + racebeam::quoted(id) +
                       (meant.empty() ? "" : "; did you mean " + meant + "?") +
                       " `racebeam claims --json --only ...` has them by the rows of the seed's "
                       "inventory, S0-62 or 62");
    }
  }
  std::vector<Claim> some;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (chosen[i]) some.push_back(all[i]);
  return some;
}

}  // namespace racebeam
