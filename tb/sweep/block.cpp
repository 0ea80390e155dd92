// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/block.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tb/scene/engines.h"
#include "tb/show/open_show.h"
#include "tb/sweep/packed.h"
#include "tb/sweep/row_digest.h"

namespace racebeam {

namespace {

using Json = nlohmann::json;

// All knobs by row: a request is read by the program that wrote it, or one of the same model.
Json knobs_json(const knob_values& k) {
  if (k.rows().empty()) return nullptr;
  Json json = Json::array();
  for (std::size_t row = 0; row < k.rows().size(); ++row) json.push_back(k[row]);
  return {{"engine", engine_of(k).name}, {"values", json}};
}

knob_values knobs_of(const Json& json) {
  if (json.is_null()) return {};
  return {engine_named(json.at("engine").get<std::string>()).knobs,
          json.at("values").get<std::vector<int>>()};
}

/// Frames with the sizes of their pictures; the pictures themselves are appended to `bytes`.
Json kept_json(const std::map<int, KeptPictures>& kept, std::string& bytes) {
  Json json = Json::array();
  for (const auto& [frame, pictures] : kept) {
    Json sizes = Json::array();
    const auto put = [&](const std::string& picture) {
      sizes.push_back(picture.size());
      bytes += picture;
    };
    put(pictures.reference);
    put(pictures.end);
    for (const std::string& link : pictures.links) put(link);
    json.push_back({frame, sizes});
  }
  return json;
}

std::map<int, KeptPictures> kept_of(const Json& json, std::string_view bytes) {
  std::map<int, KeptPictures> kept;
  for (const Json& one : json) {
    KeptPictures& pictures = kept[one.at(0).get<int>()];
    const Json& sizes = one.at(1);
    const auto take = [&](std::size_t n) {
      const auto size = sizes.at(n).get<std::size_t>();
      const std::string picture(bytes.substr(0, size));
      bytes.remove_prefix(picture.size());
      return picture;
    };
    pictures.reference = take(0);
    pictures.end = take(1);
    for (std::size_t n = 2; n < sizes.size(); ++n) pictures.links.push_back(take(n));
  }
  return kept;
}

Json block_json(const Block& block) {
  return {
      {"block", block.number},
      {"point", block.point},
      {"scene", block.scene},
      {"scene_name", block.scene_name},
      {"scene_hash", block.scene_hash},
      {"knobs", knobs_json(block.k)},
      {"base", knobs_json(block.base)},
      {"frames", block.frames},
      {"guard", block.guard},
      {"causes", block.causes},
      {"pictures", block.pictures},
      {"scan", block.scan},
      {"reference", static_cast<int>(block.reference)},
  };
}

Block block_of_json(const Json& json) {
  Block block;
  block.number = json.at("block");
  block.point = json.at("point");
  block.scene = json.at("scene");
  block.scene_name = json.at("scene_name");
  block.scene_hash = json.at("scene_hash");
  block.k = knobs_of(json.at("knobs"));
  block.base = knobs_of(json.at("base"));
  block.frames = json.at("frames").get<std::vector<int>>();
  block.guard = json.at("guard");
  block.causes = json.at("causes");
  block.pictures = json.at("pictures");
  block.scan = json.at("scan");
  block.reference = static_cast<SweepReference>(json.at("reference").get<int>());
  return block;
}

}  // namespace

// The size of the CBOR in the first line; after it the pictures.
std::string request_text(const Block& block) {
  std::string pictures;
  Json json = block_json(block);
  json["kept"] = kept_json(block.kept, pictures);
  const std::vector<std::uint8_t> bytes = Json::to_cbor(json);
  std::string text = std::to_string(bytes.size()) + "\n";
  text.append(bytes.begin(), bytes.end());
  return text += pictures;
}

Block block_of(const std::string& request) {
  const std::size_t begin = request.find('\n') + 1, size = std::stoul(request);
  const auto at = request.begin() + static_cast<std::ptrdiff_t>(begin);
  const Json json = Json::from_cbor(at, at + static_cast<std::ptrdiff_t>(size));
  Block block = block_of_json(json);
  block.kept = kept_of(json.at("kept"), std::string_view(request).substr(begin + size));
  return block;
}

std::string plan_text_of(const Block& block) { return block_json(block).dump(); }

Block block_of_plan(const std::string& text) { return block_of_json(Json::parse(text)); }

std::string answer_line(const Answer& answer) {
  const MeasuredFrame& frame = answer.frame;
  Json json = {{"block", answer.block},
               {"frame", frame.row.frame},
               {"guard", frame.row.guard},
               {"digest", frame.row.digest},
               {"values", text_of_numbers(frame.row.values)}};
  for (const auto& [name, bins] : frame.histograms)
    json["histograms"][name] = text_of_numbers(bins);
  if (!frame.causes.empty()) json["causes"] = frame.causes;
  if (!answer.made.reference.empty()) json["reference"] = hex_of(answer.made.reference);
  if (!answer.made.end.empty()) json["end"] = hex_of(answer.made.end);
  for (const std::string& link : answer.made.links) json["links"].push_back(hex_of(link));
  if (!answer.picture.empty()) json["picture"] = hex_of(answer.picture);
  return json.dump() + "\n";
}

std::string done_line(int block) { return Json{{"block", block}, {"done", true}}.dump() + "\n"; }

std::string error_line(int block, const std::string& error) {
  return Json{{"block", block}, {"error", error}}.dump(-1, ' ', false,
                                                       Json::error_handler_t::replace) +
         "\n";
}

AnswerLine read_answer(const std::string& line, int block) try {
  const Json json = Json::parse(line);
  if (json.at("block") != block) return {};
  if (json.contains("error")) return {AnswerLine::Error, {}, json["error"]};
  if (json.contains("done")) return {AnswerLine::Done};
  AnswerLine read{AnswerLine::Frame};
  Answer& answer = read.answer;
  answer.block = block;
  FrameRow& row = answer.frame.row;
  row.frame = json.at("frame");
  row.guard = json.at("guard");
  row.digest = json.at("digest");
  row.values = numbers_of_text(json.at("values").get_ref<const std::string&>());
  if (row.digest != frame_digest(row.frame, row.values)) return {};
  const auto of_key = [&](const char* key, auto& member) {
    if (json.contains(key)) json[key].get_to(member);
  };
  if (json.contains("histograms"))
    for (const auto& [name, bins] : json["histograms"].items())
      answer.frame.histograms[name] = numbers_of_text(bins.get_ref<const std::string&>());
  of_key("causes", answer.frame.causes);
  const auto bytes_of_key = [&](const char* key, std::string& member) {
    if (json.contains(key)) member = of_hex(json[key].get<std::string>());
  };
  bytes_of_key("reference", answer.made.reference);
  bytes_of_key("end", answer.made.end);
  bytes_of_key("picture", answer.picture);
  if (json.contains("links"))
    for (const Json& link : json["links"])
      answer.made.links.push_back(of_hex(link.get<std::string>()));
  return read;
} catch (const std::exception&) {
  return {};  // garbage
}

}  // namespace racebeam
