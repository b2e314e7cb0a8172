#pragma once

#include <array>
#include <filesystem>
#include <string_view>

namespace zonal {

/// The names of the cube faces +X -X +Y -Y +Z -Z in files that we write.
inline constexpr std::array<std::string_view, 6> kFaceNames = {"px", "nx", "py", "ny", "pz", "nz"};

/// The six faces in a folder, in the order above: files whose stems are, or end after a '_', '-', '.' or ' ' in, one of
/// the usual sets of names (px nx ..., posx negx ..., right left top bottom front back, +x -x ..., in any case), with
/// the extension of a picture. Throws Error{kInput} when a face is missing or there are two files for one.
std::array<std::filesystem::path, 6> find_face_files(const std::filesystem::path& folder);

}  // namespace zonal
