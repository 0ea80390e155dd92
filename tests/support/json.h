// Json: a value of JSON as tests look at it. nlohmann::json behind one source: its templates, made
// anew in each test, took three seconds of each.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iosfwd>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace racebeam {

class Json {
 public:
  Json();  ///< null
  Json(const char* text);
  Json(const std::string& text);
  template <class Number, class = std::enable_if_t<std::is_arithmetic_v<Number>>>
  Json(Number number) : Json(Tag(), held(number)) {}
  /// An array; an object if all elements are pairs of a name and a value.
  Json(std::initializer_list<Json> elements);

  static Json array(const std::vector<std::string>& texts = {});
  /// Throws std::exception if the text is no JSON.
  static Json parse(const std::string& text);

  /// Throw std::exception if there is no such part.
  Json at(const std::string& name) const;
  Json at(std::size_t index) const;
  /// Null if there is no such part.
  Json operator[](const char* name) const { return (*this)[std::string(name)]; }
  Json operator[](const std::string& name) const;
  Json operator[](int index) const { return (*this)[static_cast<std::size_t>(index)]; }
  Json operator[](std::size_t index) const;

  std::size_t size() const;
  bool empty() const { return size() == 0; }
  bool is_null() const;
  bool contains(const std::string& name) const;
  std::size_t count(const std::string& name) const { return contains(name); }
  std::vector<Json> elements() const;
  /// Of an object, by name.
  std::vector<std::pair<std::string, Json>> items() const;

  /// As int, long, std::uint64_t, bool, double or std::string. Throws std::exception if it is none.
  template <class T>
  T get() const;
  /// As the file has it, without blanks.
  std::string dump() const;

  void erase(const std::string& name);
  void push_back(const Json& element);

  friend bool operator==(const Json& a, const Json& b);
  friend bool operator!=(const Json& a, const Json& b) { return !(a == b); }
  friend bool operator<(const Json& a, const Json& b);
  friend bool operator>(const Json& a, const Json& b) { return b < a; }
  friend bool operator<=(const Json& a, const Json& b) { return !(b < a); }
  friend bool operator>=(const Json& a, const Json& b) { return !(a < b); }
  /// For GoogleTest.
  friend void PrintTo(const Json& json, std::ostream* out);

 private:
  using Held = std::shared_ptr<const nlohmann::json>;  // it, in the whole that it is a part of
  struct Tag {};
  Json(Tag, Held held);

  static Held held(bool value);
  static Held held(std::int64_t number);
  static Held held(std::uint64_t number);
  static Held held(double number);
  template <class Number>
  static Held held(Number number) {
    using Wide = std::conditional_t<std::is_signed_v<Number>, std::int64_t, std::uint64_t>;
    return held(static_cast<Wide>(number));
  }
  Json part(const nlohmann::json& part) const;

  Held held_;
};

}  // namespace racebeam
