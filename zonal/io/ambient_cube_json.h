#pragma once

#include <string>
#include <string_view>

#include "zonal/io/sh_json.h"
#include "zonal/sh/ambient_cube.h"

namespace zonal {

/// An ambient cube and what its six colours are: the value of a cube file.
struct AmbientCubeFile {
  ShQuantity quantity = ShQuantity::kRadiance;
  AmbientCube<RgbD> cube;

  bool operator==(const AmbientCubeFile&) const = default;
};

/// "+X", "-X", "+Y", "-Y", "+Z", "-Z": the sides in the order of AmbientCube.
std::string_view ambient_cube_side_name(std::size_t side);

/// {"format":"zonal-ambient-cube","version":1,"quantity":...,"frame":"z-up-right-handed","sides":{"+X":[r,g,b],...}},
/// in the shortest decimals that read back as the same doubles. Throws Error{kInput} when a colour is not finite.
std::string ambient_cube_json_text(const AmbientCubeFile&);

/// Reads that schema and no other: every field and every side must be there, once, and nothing else. Throws
/// Error{kInput} that names the field.
AmbientCubeFile parse_ambient_cube_json(std::string_view text);

}  // namespace zonal
