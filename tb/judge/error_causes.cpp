// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/error_causes.h"

#include <nlohmann/json.hpp>
#include <optional>

#include "tb/judge/tlm_pictures.h"
#include "tb/show/knobs_json.h"

namespace racebeam {

namespace {

/// The links that knobs make, and what is left between the last of them and the reference.
struct Way {
  const std::vector<ErrorLink>& links;
  ErrorCause rest;

  std::vector<ErrorCause> causes() const {
    std::vector<ErrorCause> all;
    for (const ErrorLink& link : links) all.push_back(link.cause);
    all.push_back(rest);
    return all;
  }
};

const Way& way_to(PictureReference reference) {
  static const Way geometry = {reference_geometry_links(),
                               {"ray_rest", "the camera's products; corners too far off"}};
  static const Way trace_4 = {
      reference_trace_4_links(),
      {"corner_wrap", "a corner too far for its register counts as behind the camera"}};
  return reference == PictureReference::Trace4 ? trace_4 : geometry;
}

// The pixels that differ and have no cause yet.
std::string bits_of(const GoldenPicture& picture, const GoldenPicture& end,
                    const std::vector<std::uint8_t>& causes) {
  std::string bits(end.size() / 8, '\0');
  for (std::size_t pixel = 0; pixel < end.size(); ++pixel)
    bits[pixel / 8] |=
        static_cast<char>((picture[pixel] != end[pixel] && !causes[pixel]) << (pixel % 8));
  return bits;
}

template <class Do>
void for_each_bit(const std::string& bits, const Do& act) {
  for (std::size_t byte = 0; byte < bits.size(); ++byte)
    for (int bit = 0; bits[byte] && bit < 8; ++bit)
      if (bits[byte] >> bit & 1) act(8 * byte + static_cast<std::size_t>(bit));
}

}  // namespace

const std::vector<ErrorCause>& error_causes(PictureReference reference) {
  static const std::vector<ErrorCause> geometry = way_to(PictureReference::Geometry).causes();
  static const std::vector<ErrorCause> trace_4 = way_to(PictureReference::Trace4).causes();
  return reference == PictureReference::Trace4 ? trace_4 : geometry;
}

ErrorChain::ErrorChain(const Show& show, const knobs& k, PictureReference reference)
    : show_(show),
      reference_(reference),
      end_(show, reference == PictureReference::Base ? PictureReference::Geometry : reference, k,
           k) {
  const knobs standard = show.standard_knobs();
  const std::vector<ErrorLink>& links = way_to(reference).links;
  Step now{k, true, 0};
  for (const ErrorLink& link : links) {
    Step next = now;
    if (link.lift) link.lift(next.k, standard);
    else next.residue = next.residue && !next.k.interlace;
    if (next.k != now.k || next.residue != now.residue) steps_.push_back(now);
    now = next;
    ++now.cause;
  }
  steps_.push_back(now);
  // The pixels of a picture depend on all that come behind it, too.
  std::string behind = end_.key();
  for (std::size_t step = steps_.size(); --step > 0;) {
    behind =
        knobs_json(steps_[step].k).dump() + (steps_[step].residue ? "\n" : " plain\n") + behind;
    keys_.insert(keys_.begin(), behind);
  }
}

std::vector<int> ErrorChain::by_cause(int frame, const GoldenPicture& own, const GoldenPicture& end,
                                      Links& links) const {
  links.resize(keys_.size());
  std::optional<TlmPictures> pictures;
  std::vector<std::uint8_t> causes(end.size());  // from 1 on; 0: right from there on
  for (std::size_t step = steps_.size(); --step > 0;) {
    const auto mark = static_cast<std::uint8_t>(steps_[step].cause + 1);
    std::string& link = links[step - 1];
    if (link.empty()) {
      if (!pictures) pictures.emplace(show_, frame, steps_[0].k);
      link = bits_of(steps_[step].residue ? pictures->picture(steps_[step].k)
                                          : pictures->without_residue(steps_[step].k),
                     end, causes);
    }
    for_each_bit(link, [&](std::size_t pixel) { causes[pixel] = mark; });
  }
  std::vector<int> counts(error_causes(reference_).size());
  for (std::size_t pixel = 0; pixel < end.size(); ++pixel)
    if (own[pixel] != end[pixel]) ++counts[causes[pixel] ? causes[pixel] - 1u : steps_[0].cause];
  return counts;
}

}  // namespace racebeam
