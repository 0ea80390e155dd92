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

std::optional<MappedChip> ChipCache::find(const std::string& hash) const {
  Statement select(database_,
                   "SELECT top, parameters, technology, flip_flops, cells, area, multipliers, ns, "
                   "from_register, to_register FROM chip WHERE hash = ?");
  if (!select.with(hash).next()) return {};
  const auto real = [&select](int column) -> std::optional<double> {
    if (select.kind(column) == Statement::Null) return {};
    return select.real(column);
  };
  return MappedChip{
      hash,    select.text(0), select.text(1), select.text(2), select.integer(3), select.integer(4),
      real(5), real(6),        select.real(7), select.text(8), select.text(9)};
}

void ChipCache::put(const MappedChip& chip) {
  Statement insert(database_, insert_with_digest("chip") + " ON CONFLICT DO NOTHING");
  insert.with(chip.hash, chip.top, chip.parameters, chip.technology, chip.flip_flops, chip.cells);
  if (chip.area) insert.bind(7, *chip.area);
  if (chip.multipliers) insert.bind(8, *chip.multipliers);
  insert.bind(9, chip.ns);
  insert.bind(10, chip.from);
  insert.bind(11, chip.to);
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
