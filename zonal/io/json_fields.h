#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "zonal/math/vec.h"

namespace zonal {

/// The fields of one object of a JSON document whose schema is ours, read strictly: every one must be there, once, hold
/// what it is asked for, and end() refuses those that nobody asked for. Whatever is wrong throws Error{kInput} that
/// names the field.
class JsonFields {
 public:
  /// A document that is an object. No name may stand twice in any object of it: the parser would keep the last one
  /// without a word. `subject` begins every message.
  static JsonFields of_document(std::string_view text, std::string subject);

  std::string text(const char* name);
  bool boolean(const char* name);
  /// A whole number, written as one.
  int integer(const char* name, int least, int greatest);
  /// Finite.
  double number(const char* name);
  /// Three finite numbers.
  RgbD triple(const char* name);
  /// Whether the field is null; if so, it is read.
  bool is_null(const char* name);
  /// An array of `triple`s; `each` is what one of them is.
  std::vector<RgbD> triples(const char* name, std::string_view each);
  JsonFields object(const char* name);
  /// An array of at most `most` objects.
  std::vector<JsonFields> objects(const char* name, std::string_view each, std::size_t most);
  void expect(const char* name, std::string_view text);
  /// To be called when all is read.
  void end() const;

  [[noreturn]] void wrong(const char* name, const std::string& how, std::string hint = {}) const;
  [[noreturn]] void fail(const std::string& what, std::string hint = {}) const;

 private:
  using Json = nlohmann::json;
  JsonFields(std::shared_ptr<const Json> document, const Json& object, std::string subject);
  const Json& read(const char* name);
  const Json& array(const char* name);

  std::shared_ptr<const Json> document_;  // keeps object_ alive
  const Json* object_;
  std::string subject_;
  std::size_t read_ = 0;
};

}  // namespace zonal
