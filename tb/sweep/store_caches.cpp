// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/store_caches.h"

#include "tb/sweep/schema.h"

namespace racebeam {

std::optional<UnitSilicon> UnitCache::find(const std::string& hash) const {
  Statement select(database_,
                   "SELECT unit, parameters, recipe, flip_flops, cells, area FROM unit "
                   "WHERE hash = ?");
  if (!select.with(hash).next()) return {};
  UnitSilicon unit{
      hash, select.text(0), select.text(1), select.text(2), select.integer(3), select.integer(4),
      {}};
  if (select.kind(5) != Statement::Null) unit.area = select.real(5);
  return unit;
}

void UnitCache::put(const UnitSilicon& unit) {
  Statement insert(database_, insert_with_digest("unit") + " ON CONFLICT DO NOTHING");
  insert.with(unit.hash, unit.unit, unit.parameters, unit.recipe, unit.flip_flops, unit.cells);
  if (unit.area) insert.bind(7, *unit.area);
  insert.run();
}

bool ReferenceCache::has(const std::string& hash) const {
  Statement select(database_, "SELECT 1 FROM reference WHERE hash = ?");
  return select.with(hash).next();
}

std::optional<std::string> ReferenceCache::find(const std::string& hash) const {
  Statement select(database_, "SELECT picture FROM reference WHERE hash = ?");
  if (!select.with(hash).next()) return {};
  return select.text(0);
}

void ReferenceCache::put(const std::string& hash, std::string_view picture) {
  Statement insert(database_, insert_with_digest("reference") + " ON CONFLICT DO NOTHING");
  insert.with(hash);
  insert.bind_blob(2, picture);
  insert.run();
}

}  // namespace racebeam
