// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/json.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>

namespace racebeam {

using nlohmann::json;

Json::Json() : Json(Tag(), std::make_shared<json>()) {}
Json::Json(Tag, Held held) : held_(std::move(held)) {}
Json::Json(const char* text) : Json(Tag(), std::make_shared<json>(text)) {}
Json::Json(const std::string& text) : Json(Tag(), std::make_shared<json>(text)) {}

Json::Json(std::initializer_list<Json> elements) {
  const bool object = std::all_of(elements.begin(), elements.end(), [](const Json& element) {
    return element.held_->is_array() && element.size() == 2 && element.held_->front().is_string();
  });
  auto all = std::make_shared<json>(object ? json::object() : json::array());
  for (const Json& element : elements)
    if (object) (*all)[element.held_->front().get<std::string>()] = element.held_->back();
    else all->push_back(*element.held_);
  held_ = all;
}

Json::Held Json::held(bool value) { return std::make_shared<json>(value); }
Json::Held Json::held(std::int64_t number) { return std::make_shared<json>(number); }
Json::Held Json::held(std::uint64_t number) { return std::make_shared<json>(number); }
Json::Held Json::held(double number) { return std::make_shared<json>(number); }

Json Json::array(const std::vector<std::string>& texts) {
  auto all = std::make_shared<json>(json::array());
  for (const std::string& text : texts) all->push_back(text);
  return {Tag(), all};
}

Json Json::parse(const std::string& text) {
  return {Tag(), std::make_shared<json>(json::parse(text))};
}

Json Json::part(const json& part) const { return {Tag(), Held(held_, &part)}; }

Json Json::at(const std::string& name) const { return part(held_->at(name)); }
Json Json::at(std::size_t index) const { return part(held_->at(index)); }

Json Json::operator[](const std::string& name) const { return contains(name) ? at(name) : Json(); }

Json Json::operator[](std::size_t index) const {
  return held_->is_array() && index < size() ? at(index) : Json();
}

std::size_t Json::size() const { return held_->size(); }
bool Json::is_null() const { return held_->is_null(); }
bool Json::contains(const std::string& name) const { return held_->contains(name); }

std::vector<Json> Json::elements() const {
  std::vector<Json> all;
  for (const json& element : *held_) all.push_back(part(element));
  return all;
}

std::vector<std::pair<std::string, Json>> Json::items() const {
  std::vector<std::pair<std::string, Json>> all;
  for (const auto& [name, value] : held_->items()) all.emplace_back(name, part(value));
  return all;
}

template <>
int Json::get() const {
  return held_->get<int>();
}
template <>
long Json::get() const {
  return held_->get<long>();
}
template <>
std::uint64_t Json::get() const {
  return held_->get<std::uint64_t>();
}
template <>
bool Json::get() const {
  return held_->get<bool>();
}
template <>
double Json::get() const {
  return held_->get<double>();
}
template <>
std::string Json::get() const {
  return held_->get<std::string>();
}

std::string Json::dump() const { return held_->dump(); }

void Json::erase(const std::string& name) {
  auto rest = std::make_shared<json>(*held_);
  rest->erase(name);
  held_ = rest;
}

void Json::push_back(const Json& element) {
  auto more = std::make_shared<json>(*held_);
  more->push_back(*element.held_);
  held_ = more;
}

bool operator==(const Json& a, const Json& b) { return *a.held_ == *b.held_; }
bool operator<(const Json& a, const Json& b) { return *a.held_ < *b.held_; }
void PrintTo(const Json& json, std::ostream* out) { *out << json.dump(); }

}  // namespace racebeam
