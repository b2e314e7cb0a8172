#include "zonal/io/json_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "zonal/base/error.h"

namespace zonal {
namespace {

using nlohmann::json;

/// Listens to the parser for a name that stands twice in one object.
class Names {
 public:
  bool operator()(int depth, json::parse_event_t event, const json& parsed) {
    const auto d = static_cast<std::size_t>(depth);
    if (event == json::parse_event_t::object_start) {
      seen_.resize(std::max(seen_.size(), d + 2));
      seen_[d + 1].clear();
    }
    if (event == json::parse_event_t::key && !seen_.at(d).insert(parsed.get<std::string>()).second) {
      twice = parsed.get<std::string>();
    }
    return true;
  }
  std::optional<std::string> twice;

 private:
  std::vector<std::set<std::string>> seen_;  // seen_[depth]: of the object that is open there
};

bool is_finite_number(const json& value) { return value.is_number() && std::isfinite(value.get<double>()); }

std::optional<RgbD> triple_of(const json& value) {
  if (!value.is_array() || value.size() != 3) return std::nullopt;
  for (const json& number : value) {
    if (!is_finite_number(number)) return std::nullopt;
  }
  return RgbD{value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
}

}  // namespace

JsonFields::JsonFields(std::shared_ptr<const Json> document, const Json& object, std::string subject)
    : document_(std::move(document)), object_(&object), subject_(std::move(subject)) {
  if (!object.is_object()) fail("is not an object");
}

JsonFields JsonFields::of_document(std::string_view text, std::string subject) {
  const auto refuse = [&](const std::string& what) { throw Error(ErrorKind::kInput, subject + ": " + what); };
  Names names;
  auto document = std::make_shared<json>();
  try {
    *document = json::parse(text, std::ref(names));
  } catch (const json::exception&) {
    refuse("this is not JSON");
  }
  if (!document->is_object()) refuse("this is JSON, but not an object");
  if (names.twice) refuse(fmt::format("the field \"{}\" appears twice", *names.twice));
  const json& object = *document;
  return {std::move(document), object, std::move(subject)};
}

void JsonFields::fail(const std::string& what, std::string hint) const {
  throw Error(ErrorKind::kInput, subject_ + ": " + what, std::move(hint));
}

void JsonFields::wrong(const char* name, const std::string& how, std::string hint) const {
  fail(fmt::format("\"{}\" {}", name, how), std::move(hint));
}

const nlohmann::json& JsonFields::read(const char* name) {
  const auto found = object_->find(name);
  if (found == object_->end()) wrong(name, "is missing");
  ++read_;
  return *found;
}

const nlohmann::json& JsonFields::array(const char* name) {
  const json& value = read(name);
  if (!value.is_array()) wrong(name, "is not an array");
  return value;
}

std::string JsonFields::text(const char* name) {
  const json& value = read(name);
  if (!value.is_string()) wrong(name, "is not a string");
  return value.get<std::string>();
}

void JsonFields::expect(const char* name, std::string_view expected) {
  const std::string found = text(name);
  if (found != expected) wrong(name, fmt::format("is \"{}\", must be \"{}\"", found, expected));
}

bool JsonFields::boolean(const char* name) {
  const json& value = read(name);
  if (!value.is_boolean()) wrong(name, "is not true or false");
  return value.get<bool>();
}

int JsonFields::integer(const char* name, int least, int greatest) {
  const json& value = read(name);
  // As double: an integer too large for any integer type is a number still, and out of range.
  if (!value.is_number_integer() || !(value.get<double>() >= least && value.get<double>() <= greatest)) {
    if (least == greatest) wrong(name, fmt::format("must be {}", least));
    wrong(name, fmt::format("is not an integer from {} to {}", least, greatest));
  }
  return value.get<int>();
}

double JsonFields::number(const char* name) {
  const json& value = read(name);
  if (!is_finite_number(value)) wrong(name, "is not a finite number");
  return value.get<double>();
}

RgbD JsonFields::triple(const char* name) {
  const std::optional<RgbD> value = triple_of(read(name));
  if (!value) wrong(name, "is not three finite numbers");
  return *value;
}

bool JsonFields::is_null(const char* name) {
  const auto found = object_->find(name);
  if (found == object_->end() || !found->is_null()) return false;
  ++read_;
  return true;
}

std::vector<RgbD> JsonFields::triples(const char* name, std::string_view each) {
  std::vector<RgbD> values;
  for (const json& row : array(name)) {
    const std::optional<RgbD> value = triple_of(row);
    if (!value) fail(fmt::format("{} {} is not three finite numbers [r, g, b]", each, values.size()));
    values.push_back(*value);
  }
  return values;
}

JsonFields JsonFields::object(const char* name) {
  const json& value = read(name);
  if (!value.is_object()) wrong(name, "is not an object");
  return {document_, value, fmt::format("{}: \"{}\"", subject_, name)};
}

std::vector<JsonFields> JsonFields::objects(const char* name, std::string_view each, std::size_t most) {
  const json& list = array(name);
  if (list.size() > most) wrong(name, fmt::format("has {} entries, a file has at most {}", list.size(), most));
  std::vector<JsonFields> all;
  for (const json& entry : list) {
    all.push_back({document_, entry, fmt::format("{}: {} {}", subject_, each, all.size())});
  }
  return all;
}

void JsonFields::end() const {
  if (object_->size() != read_) fail("there are fields that the format does not have");
}

}  // namespace zonal
