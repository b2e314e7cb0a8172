#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "zonal/io/engine.h"
#include "zonal/io/output_folder.h"
#include "zonal/report/bake.h"

namespace zonal {

/// How maps are stored. Pictures: one file for each level.
enum class MapFormat { kKtx2, kExr, kHdr, kPng };

std::string_view name_of(MapFormat);  // "ktx2", "exr", "hdr", "png"
std::optional<MapFormat> map_format_named(std::string_view name);

struct BakeFileOptions {
  MapFormat format = MapFormat::kKtx2;
  bool float32 = false;                      ///< KTX2: 32-bit floats in place of 16
  Layout layout = Layout::kCubeCross;        ///< of cubes as pictures; one of the kCube ones
  const EngineConvention* engine = nullptr;  ///< whose axes and coefficients; nullptr: the memory frame's
  std::string writer = "zonal";              ///< program and version
};

/// A file that was written, and what can be wrong with it.
struct BakedFile {
  WrittenFile file;
  std::string hash;         ///< "fnv1a64:..."
  double error_bound = -1;  ///< the worst of its maps, as a fraction of the mean; negative: nothing was approximated
  std::string warning;      ///< what the format could not hold; empty: nothing was lost
};

/// Writes environment, irradiance and specular maps, the split-sum tables, coefficients and shader, in this order, into
/// an open folder that the caller commits. Cubes are turned for the engine by moving texels, not by resampling. Every
/// KTX2 file passes check_ktx2. Throws Error{kOutput}, Error{kInput} for coefficients that are not finite.
std::vector<BakedFile> write_bake(const Bake&, const BakeOptions&, const BakeFileOptions&, OutputFolder&);

/// The turn (or mirror) of the light that makes a cube of ours the one that the engine looks up as it is.
Rotation cube_turn(const EngineConvention&);

}  // namespace zonal
