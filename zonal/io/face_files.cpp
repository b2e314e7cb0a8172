#include "zonal/io/face_files.h"

#include <algorithm>
#include <string>
#include <vector>

#include "zonal/base/error.h"

namespace zonal {
namespace fs = std::filesystem;
namespace {

using Names = std::array<std::string_view, 6>;

/// Sets of names in use. right, left, top, bottom, front, back are +X -X +Y -Y +Z -Z of the cube sampler.
constexpr std::array<Names, 5> kNameSets = {{
    kFaceNames,
    {"posx", "negx", "posy", "negy", "posz", "negz"},
    {"right", "left", "top", "bottom", "front", "back"},
    {"right", "left", "up", "down", "front", "back"},
    {"+x", "-x", "+y", "-y", "+z", "-z"},
}};

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  return text;
}

/// Beside the pictures there may be anything else (licences, settings) under the same names.
bool may_be_picture(const fs::path& file) {
  constexpr std::array<std::string_view, 9> kExtensions = {".exr", ".hdr", ".rgbe", ".pic", ".pfm",
                                                           ".png", ".jpg", ".jpeg", ".tga"};
  return std::find(kExtensions.begin(), kExtensions.end(), lower(file.extension().string())) != kExtensions.end();
}

bool ends_with_name(const std::string& stem, std::string_view name) {
  if (!stem.ends_with(name)) return false;
  if (stem.size() == name.size()) return true;
  return std::string_view("_-. ").find(stem[stem.size() - name.size() - 1]) != std::string_view::npos;
}

Error wrong_folder(const fs::path& folder, const std::string& what) {
  return Error(ErrorKind::kInput, folder.string() + ": " + what,
               "put six files in it named px nx py ny pz nz (or posx negx ..., or right left top bottom front back)");
}

}  // namespace

std::array<fs::path, 6> find_face_files(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (it->is_regular_file(error) && may_be_picture(it->path())) files.push_back(it->path());
  }
  if (error) throw wrong_folder(folder, "the folder cannot be read");
  std::sort(files.begin(), files.end());  // folders list their files in any order

  std::size_t most_found = 0;
  std::string missing;
  for (const Names& names : kNameSets) {
    std::array<fs::path, 6> faces;
    std::size_t found = 0;
    std::string first_missing;
    for (std::size_t f = 0; f < names.size(); ++f) {
      for (const fs::path& file : files) {
        if (!ends_with_name(lower(file.stem().string()), names[f])) continue;
        if (!faces[f].empty()) {
          throw wrong_folder(
              folder, "two files for one face: " + faces[f].filename().string() + " and " + file.filename().string());
        }
        faces[f] = file;
      }
      found += !faces[f].empty();
      if (faces[f].empty() && first_missing.empty()) first_missing = names[f];
    }
    if (found == names.size()) return faces;
    if (found > most_found) {
      most_found = found;
      missing = first_missing;
    }
  }
  if (most_found > 0) {
    throw wrong_folder(folder, "only " + std::to_string(most_found) + " of six cube faces: there is no " + missing);
  }
  throw wrong_folder(folder, "no cube faces in this folder");
}

}  // namespace zonal
