#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace zonal {

/// "a, b or c".
template <class Range, class Name>
std::string names_of(const Range& values, Name name) {
  std::string list;
  std::size_t i = 0;
  for (const auto& value : values) {
    if (i > 0) list += i + 1 == std::size(values) ? " or " : ", ";
    list += name(value);
    ++i;
  }
  return list;
}

/// An option that takes a name: `parse` turns it into the value or returns nullopt, then `names` says what it could
/// have been.
template <class Target, class Parse>
CLI::Option* add_choice(CLI::App& verb, const std::string& option, Target& target, Parse parse,
                        const std::string& names, const std::string& help) {
  return verb
      .add_option_function<std::string>(
          option,
          [&target, parse, names, option](const std::string& word) {
            const auto value = parse(word);
            if (!value) throw CLI::ValidationError(option, "'" + word + "' is not one of " + names);
            target = *value;
          },
          help + ": " + names)
      ->type_name("NAME");
}

}  // namespace zonal
