#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "zonal/gl/gpu_mesh.h"
#include "zonal/gl/program.h"
#include "zonal/gl/texture.h"
#include "zonal/view/mesh.h"
#include "zonal/view/view_data.h"
#include "zonal/view/view_state.h"

namespace zonal {

/// How far a technique is from its exact answer, over the pixels of the object.
struct Difference {
  double rms = 0;  ///< of the difference over that of the exact answer; 0 where that is black
  std::int64_t pixels = 0;
};

/// What a picture of values holds.
enum class Measured { kTechnique = 2, kExact, kNormal, kPosition, kTextureCoordinates, kBackground };

/// An object in an environment, on the graphics side. Needs a current context of OpenGL 4.1 for all its life.
class Scene {
 public:
  Scene();
  ~Scene();
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  void set_light(const ViewData&);
  /// In place of the light's texture of this name, until there is another light.
  void set_texture(const ViewTexture&);
  void set_mesh(const Mesh&);

  /// Draws into the current target: the object, arrows of the lights that it is shaded by, the background. Throws
  /// Error{kUsage} when the driver refuses a shader.
  void draw(const ViewState&, int width, int height);
  /// Draws the technique and its exact answer once more, small, and compares them.
  Difference difference(const ViewState&, int width = 320, int height = 180);
  /// Linear values in place of colours, NaN where the object is not; of the background everywhere.
  Image<Rgb> values(const ViewState&, Measured, int width, int height);

 private:
  const GpuProgram& program_of(const Technique&, bool alone);
  void set_shared(const GpuProgram&, const ViewState&, int width, int height, int measure) const;
  void draw_mesh(const ViewState&, int width, int height, int measure);
  void draw_arrows(const ViewState&, int width, int height);
  void draw_background(const ViewState&, int width, int height, int measure);

  std::map<std::string, GpuTexture, std::less<>> textures_;
  std::vector<ViewUniform> uniforms_;
  std::map<std::pair<std::string_view, bool>, GpuProgram>
      programs_;  // of the technique alone, and with the exact answer
  std::optional<GpuProgram> background_, arrows_;
  std::optional<GpuMesh> mesh_, arrow_;
  std::uint32_t empty_array_ = 0;
};

}  // namespace zonal
