#include "zonal/io/json_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "zonal/base/check.h"
#include "zonal/io/utf8.h"

namespace zonal {
namespace {

template <class Real>
std::string shortest_of(Real value) {
  std::array<char, 32> buffer;  // the longest shortest double, "-1.7976931348623157e+308", has 24 characters
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  check(error == std::errc(), "a number does not fit its buffer");
  return {buffer.data(), end};
}

/// "-0" would be read as an integer by some, and lose its sign.
template <class Real>
std::string json_number(Real value) {
  return value == 0 && std::signbit(value) ? "-0.0" : shortest_of(value);
}

std::string quoted(std::string_view text) {
  constexpr char kHex[] = "0123456789abcdef";
  std::string out = "\"";
  while (!text.empty()) {
    const std::size_t length = utf8_character_length(text);
    const char c = text.front();
    const auto code = static_cast<unsigned char>(c);
    if (length == 0) {
      out += "\\ufffd";
    } else if (c == '"' || c == '\\') {
      out += {'\\', c};
    } else if (code < 0x20) {
      out += "\\u00";
      out += {kHex[code >> 4], kHex[code & 15]};
    } else {
      out += text.substr(0, length);
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return out + '"';
}

}  // namespace

std::string shortest(float value) { return shortest_of(value); }
std::string shortest(double value) { return shortest_of(value); }

JsonValue::JsonValue(float value) : value_(nullptr) {
  if (std::isfinite(value)) value_ = Number{json_number(value)};
}
JsonValue::JsonValue(double value) : value_(nullptr) {
  if (std::isfinite(value)) value_ = Number{json_number(value)};
}

class JsonPrinter {
 public:
  void print(const JsonValue& value) {
    std::visit([this](const auto& held) { print_held(held); }, value.value_);
  }
  std::string text;

 private:
  void print_held(std::nullptr_t) { text += "null"; }
  void print_held(bool value) { text += value ? "true" : "false"; }
  void print_held(const JsonValue::Number& number) { text += number.text; }
  void print_held(const std::string& string) { text += quoted(string); }
  void print_held(const JsonValue::Array& elements) {
    const bool flat = std::ranges::none_of(elements, is_nested);
    print_list('[', ']', elements, flat, [this](const JsonValue& element) { print(element); });
  }
  void print_held(const JsonValue::Object& fields) {
    print_list('{', '}', fields, fields.empty(), [this](const auto& field) {
      text += quoted(field.first) + ": ";
      print(field.second);
    });
  }

  static bool is_nested(const JsonValue& value) {
    return std::holds_alternative<JsonValue::Array>(value.value_) ||
           std::holds_alternative<JsonValue::Object>(value.value_);
  }

  template <class List, class PrintElement>
  void print_list(char open, char close, const List& list, bool flat, PrintElement print_element) {
    text += open;
    indent_ += 2;
    bool first = true;
    for (const auto& element : list) {
      if (!first) text += flat ? ", " : ",";
      if (!flat) new_line();
      print_element(element);
      first = false;
    }
    indent_ -= 2;
    if (!flat) new_line();
    text += close;
  }
  void new_line() { text += '\n' + std::string(indent_, ' '); }

  std::size_t indent_ = 0;
};

std::string json_text(const JsonValue& value) {
  JsonPrinter printer;
  printer.print(value);
  return printer.text + '\n';
}

}  // namespace zonal
