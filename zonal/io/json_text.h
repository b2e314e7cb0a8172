#pragma once

#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace zonal {

/// A JSON document to be written. Fields keep the order in which they were added, and numbers are written in the
/// shortest form that reads back as the same float or double (std::to_chars), so that the same values give the same
/// bytes.
class JsonValue {
 public:
  using Array = std::vector<JsonValue>;
  using Object = std::vector<std::pair<std::string, JsonValue>>;

  JsonValue() : value_(nullptr) {}
  JsonValue(std::nullptr_t) : value_(nullptr) {}
  JsonValue(bool value) : value_(value) {}
  JsonValue(std::integral auto value) : value_(Number{std::to_string(value)}) {}
  /// JSON knows no infinity and no NaN: they become null.
  JsonValue(float value);
  JsonValue(double value);
  JsonValue(const char* text) : value_(std::string(text)) {}
  JsonValue(std::string_view text) : value_(std::string(text)) {}
  JsonValue(std::string text) : value_(std::move(text)) {}
  JsonValue(Array elements) : value_(std::move(elements)) {}
  JsonValue(Object fields) : value_(std::move(fields)) {}

 private:
  struct Number {
    std::string text;
  };
  std::variant<std::nullptr_t, bool, Number, std::string, Array, Object> value_;

  friend class JsonPrinter;
};

/// The document as text: two spaces a level, arrays without nested values on one line, a newline at the end. Strings
/// that are not UTF-8 (file names may be anything) get U+FFFD for each byte that is not.
std::string json_text(const JsonValue&);

/// The shortest decimal that reads back as the same value.
std::string shortest(float);
std::string shortest(double);

}  // namespace zonal
