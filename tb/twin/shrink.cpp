// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/shrink.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace racebeam {

namespace {

/// An input gets one value for some clocks.
struct Edit {
  std::size_t input;
  std::uint64_t place;  ///< the clock that it is about
  std::uint64_t from, to, value;
};

class Shrinker {
 public:
  Shrinker(const std::string& port, const LegalInputs& legal, const FindStream& find,
           const ShrinkEffort& effort)
      : port_(port), legal_(legal), find_(find), effort_(effort) {}

  bool cut_to_last_clocks(const PortStream& found);
  void make_small();
  ShrunkStream result() && { return {std::move(best_), difference_, plays_}; }

 private:
  using Edits = void (Shrinker::*)(std::size_t input, std::vector<Edit>& edits) const;

  std::uint64_t clocks() const { return best_.clocks(); }
  std::uint64_t plays_left(std::uint64_t clocks) const;
  std::optional<std::size_t> take_first(std::size_t count, std::uint64_t longest,
                                        const Streams& streams);
  bool remove_clocks();
  bool remove_seeks();
  bool edit(Edits edits);
  void hold(std::size_t input, std::vector<Edit>& edits) const;
  void join(std::size_t input, std::vector<Edit>& edits) const;
  void simplify(std::size_t input, std::vector<Edit>& edits) const;
  std::uint64_t run_end(std::size_t input, std::uint64_t from) const;

  const std::string port_;
  const LegalInputs& legal_;
  const FindStream& find_;
  const ShrinkEffort effort_;
  PortStream best_;
  StreamDifference difference_;
  std::uint64_t spent_ = 0, plays_ = 0;
};

std::uint64_t Shrinker::plays_left(std::uint64_t clocks) const {
  return (effort_.clocks - std::min(effort_.clocks, spent_)) / (clocks + effort_.play);
}

/// Goes on with the first of `count` streams that fails at the port; they have `longest` clocks at
/// most. Its number.
std::optional<std::size_t> Shrinker::take_first(std::size_t count, std::uint64_t longest,
                                                const Streams& streams) {
  const auto begun = [&](std::size_t number) {
    PortStream stream = streams(number);
    if (stream.clocks() > 0) stream.begin_in_reset();
    return stream;
  };
  count = std::min<std::size_t>(count, plays_left(longest));
  const std::optional<StreamHit> hit = find_(port_, count, begun);
  const std::size_t plays = hit ? hit->number + 1 : count;
  plays_ += plays;
  spent_ += plays * (longest + effort_.play);
  if (!hit) return std::nullopt;
  PortStream stream = begun(hit->number);
  stream.cut(hit->difference.clock + 1);
  best_ = std::move(stream);
  difference_ = hit->difference;
  return hit->number;
}

/// The last 1, 2, 4, ... clocks, until they fail; a counter of frames may begin where it was.
bool Shrinker::cut_to_last_clocks(const PortStream& found) {
  const std::uint64_t all = found.clocks();
  for (std::uint64_t last = 1, before = 0; before + 1 < all; before = last, last *= 2) {
    last = std::min(last, all - 1);
    const auto cut = [&](std::size_t number) {
      PortStream stream = found.without(1, all - last);
      if (number > 0) stream.seeks[1] = found.frames[all - last];
      return stream;
    };
    if (take_first(found.frames.empty() ? 1 : 2, last, cut)) return true;
  }
  return false;
}

void Shrinker::make_small() {
  for (bool less = true; less && plays_left(clocks()) > 0;) {
    less = remove_clocks();
    less |= edit(&Shrinker::hold);
    less |= remove_seeks();
    if (less) continue;  // values only of what is left
    less |= edit(&Shrinker::join);
    less |= edit(&Shrinker::simplify);
  }
}

/// Halves, quarters, ... single clocks, from the front on.
bool Shrinker::remove_clocks() {
  bool any = false;
  for (std::uint64_t part = std::max<std::uint64_t>(1, clocks() / 2); part > 0; part /= 2) {
    if (plays_left(clocks()) < 2 * clocks() / part) break;  // of a long one, rather the inputs
    for (std::uint64_t at = 1; at < clocks();) {
      const auto hit =
          take_first((clocks() - at + part - 1) / part, clocks(), [&](std::size_t number) {
            const std::uint64_t from = at + number * part;
            return best_.without(from, std::min(from + part, clocks()));
          });
      if (!hit) break;
      any = true;
      at += *hit * part;
    }
  }
  return any;
}

bool Shrinker::remove_seeks() {
  bool any = false;
  while (take_first(best_.seeks.size(), clocks(), [&](std::size_t number) {
    PortStream less = best_;
    less.seeks.erase(std::next(less.seeks.begin(), static_cast<std::ptrdiff_t>(number)));
    return less;
  }))
    any = true;
  return any;
}

/// Takes whatever edit still fails, once through all inputs and clocks.
bool Shrinker::edit(Edits edits) {
  std::pair<std::size_t, std::uint64_t> place{0, 0};
  for (bool any = false;; any = true) {
    std::vector<Edit> all;
    for (std::size_t input = place.first; input < best_.inputs.size(); ++input)
      (this->*edits)(input, all);
    all.erase(
        std::remove_if(all.begin(), all.end(),
                       [&](const Edit& one) { return std::pair(one.input, one.place) < place; }),
        all.end());
    const auto hit = take_first(all.size(), clocks(), [&](std::size_t number) {
      const Edit& one = all[number];
      PortStream stream = best_;
      for (std::uint64_t clock = one.from; clock < one.to; ++clock)
        stream.at(clock, one.input) = one.value;
      return stream;
    });
    if (!hit) return any;
    place = {all[*hit].input, all[*hit].place};
  }
}

/// An input that moves rests, or keeps one of the values that it has.
void Shrinker::hold(std::size_t input, std::vector<Edit>& edits) const {
  constexpr std::size_t MostValues = 5;
  if (!best_.moves(input)) return;
  std::vector<std::uint64_t> values;
  const auto add = [&](std::uint64_t value) {
    if (values.size() == MostValues ||
        std::find(values.begin(), values.end(), value) != values.end())
      return;
    values.push_back(value);
    edits.push_back({input, 1, 1, clocks(), value});
  };
  add(best_.inputs[input].rest);
  add(best_.at(clocks() - 1, input));
  for (std::uint64_t clock = 1; clock < clocks(); ++clock) add(best_.at(clock, input));
}

/// Where the value that an input has in a clock ends.
std::uint64_t Shrinker::run_end(std::size_t input, std::uint64_t from) const {
  std::uint64_t end = from + 1;
  while (end < clocks() && best_.at(end, input) == best_.at(from, input)) ++end;
  return end;
}

/// A value gives way to the one before or after it.
void Shrinker::join(std::size_t input, std::vector<Edit>& edits) const {
  for (std::uint64_t from = 1, to = run_end(input, from); to < clocks();
       from = to, to = run_end(input, from)) {
    edits.push_back({input, from, to, run_end(input, to), best_.at(from, input)});
    edits.push_back({input, from, from, to, best_.at(to, input)});
  }
}

/// A value rests, or loses one of its bits.
void Shrinker::simplify(std::size_t input, std::vector<Edit>& edits) const {
  const PortStream::Input& port = best_.inputs[input];
  for (std::uint64_t from = 1, to = 1; from < clocks(); from = to) {
    to = run_end(input, from);
    const std::uint64_t value = best_.at(from, input);
    if (value == port.rest) continue;
    edits.push_back({input, from, from, to, port.rest});
    for (int bit = port.bits - 1; bit >= 0 && port.reset < 0; --bit) {
      const std::uint64_t less = value & ~(std::uint64_t{1} << bit);
      if (less != value && raw_bits(legal_.legal(port.name, less), port.bits) == less)
        edits.push_back({input, from, from, to, less});
    }
  }
}

}  // namespace

std::optional<ShrunkStream> shrink(const PortStream& found, const std::string& port,
                                   const LegalInputs& legal, const FindStream& find,
                                   const ShrinkEffort& effort) {
  Shrinker shrinker(port, legal, find, effort);
  if (!shrinker.cut_to_last_clocks(found)) return std::nullopt;
  shrinker.make_small();
  return std::move(shrinker).result();
}

}  // namespace racebeam
