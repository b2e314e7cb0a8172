#pragma once

namespace zonal {

/// The program and its version, as files name their writer. CMake reads the number from this line.
inline constexpr const char* kProgram = "zonal 0.1.0";

}  // namespace zonal
