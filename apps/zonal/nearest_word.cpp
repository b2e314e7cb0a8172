#include "apps/zonal/nearest_word.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "zonal/base/check.h"

namespace zonal {
namespace {

int distance(std::string_view a, std::string_view b) {
  std::vector<int> row(b.size() + 1);  // row[j]: from the first letters of a to the first j of b
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    int diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const int replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest_word(std::string_view typed, std::span<const std::string> words) {
  check(!words.empty(), "there must be a word to choose");
  return *std::min_element(words.begin(), words.end(), [&](const std::string& a, const std::string& b) {
    return distance(typed, a) < distance(typed, b);
  });
}

}  // namespace zonal
