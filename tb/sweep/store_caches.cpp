// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/store_caches.h"

#include <zlib.h>

#include <limits>
#include <stdexcept>

#include "tb/sweep/schema.h"
#include "tb/sweep/store_errors.h"

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

std::optional<std::string> ReferenceCache::find(const std::string& hash) const {
  Statement select(database_, "SELECT bytes, picture FROM reference WHERE hash = ?");
  if (!select.with(hash).next()) return {};
  const std::string packed = select.text(1);
  const std::int64_t bytes = select.integer(0);
  const auto damaged = [this, &hash] {
    return DamagedStore(database_.file(), database_.folder(), "the reference picture " + hash);
  };
  if (bytes < 0 || bytes > std::numeric_limits<std::int32_t>::max()) throw damaged();
  std::string picture(static_cast<std::size_t>(bytes), '\0');
  uLongf size = picture.size();
  if (uncompress(reinterpret_cast<Bytef*>(picture.data()), &size,
                 reinterpret_cast<const Bytef*>(packed.data()), packed.size()) != Z_OK ||
      size != picture.size())
    throw damaged();
  return picture;
}

void ReferenceCache::put(const std::string& hash, std::string_view picture) {
  uLongf size = compressBound(picture.size());
  std::string packed(size, '\0');
  if (compress(reinterpret_cast<Bytef*>(packed.data()), &size,
               reinterpret_cast<const Bytef*>(picture.data()), picture.size()) != Z_OK)
    throw std::bad_alloc();
  packed.resize(size);
  Statement insert(database_, insert_with_digest("reference") + " ON CONFLICT DO NOTHING");
  insert.with(hash, static_cast<std::int64_t>(picture.size()));
  insert.bind_blob(3, packed);
  insert.run();
}

}  // namespace racebeam
