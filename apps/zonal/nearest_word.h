#pragma once

#include <span>
#include <string>
#include <string_view>

namespace zonal {

/// The word with the fewest insertions, deletions and replacements (Levenshtein 1966) away, the first of equals.
/// `words` has one at least.
std::string nearest_word(std::string_view typed, std::span<const std::string> words);

}  // namespace zonal
