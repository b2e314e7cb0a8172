#include "zonal/view/shader_names.h"

#include <algorithm>
#include <map>
#include <regex>
#include <vector>

namespace zonal {
namespace {

/// In a piece of shader text.
std::set<std::string> names_in(const std::string& text) {
  static const std::regex kName("[A-Za-z_][A-Za-z_0-9]*");
  std::set<std::string> names;
  for (auto it = std::sregex_iterator(text.begin(), text.end(), kName); it != std::sregex_iterator(); ++it) {
    names.insert(it->str());
  }
  return names;
}

/// The functions of a shader by their names, with their text.
std::map<std::string, std::string> functions_of(const std::string& shader) {
  static const std::regex kComment("//[^\n]*"), kHead("([A-Za-z_][A-Za-z_0-9]*)\\s*\\([^()]*\\)\\s*$");
  const std::string code = std::regex_replace(shader, kComment, "");
  std::map<std::string, std::string> functions;
  std::size_t start = 0;  // of what stands outside of all braces
  for (std::size_t open; (open = code.find('{', start)) != std::string::npos;) {
    std::size_t end = open + 1;
    for (int depth = 1; depth > 0 && end < code.size(); ++end)
      depth += code[end] == '{' ? 1 : code[end] == '}' ? -1 : 0;
    const std::size_t head = std::min(open, code.find_last_of(";}", open) + 1);
    const std::string before = code.substr(std::max(start, head), open - std::max(start, head));
    std::smatch found;
    if (std::regex_search(before, found, kHead)) functions[found[1]] += code.substr(open, end - open);
    start = end;
  }
  return functions;
}

}  // namespace

std::set<std::string> names_reached(const std::string& shader) {
  const std::map<std::string, std::string> functions = functions_of(shader);
  std::set<std::string> called;
  std::vector<std::string> waiting = {"main"};
  while (!waiting.empty()) {
    const auto function = functions.find(waiting.back());
    waiting.pop_back();
    if (function == functions.end()) continue;
    for (const std::string& name : names_in(function->second)) {
      if (called.insert(name).second) waiting.push_back(name);
    }
  }
  return called;
}

}  // namespace zonal
