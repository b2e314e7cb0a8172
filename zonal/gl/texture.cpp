#include "zonal/gl/texture.h"

#include <epoxy/gl.h>

namespace zonal {

GpuTexture::GpuTexture(const ViewTexture& texture) {
  const bool cube = texture.shape == TextureShape::kCube;
  target_ = cube ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D;
  glGenTextures(1, &id_);
  glBindTexture(target_, id_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  const int format = texture.table ? GL_RGB32F : GL_RGB16F;
  for (int level = 0; level < static_cast<int>(texture.levels.size()); ++level) {
    const Image<Rgb>& image = texture.levels[static_cast<std::size_t>(level)];
    if (!cube) {
      glTexImage2D(GL_TEXTURE_2D, level, format, image.width(), image.height(), 0, GL_RGB, GL_FLOAT,
                   image.values().data());
      continue;
    }
    const int edge = image.width();
    for (int face = 0; face < 6; ++face) {
      glTexImage2D(static_cast<GLenum>(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face), level, format, edge, edge, 0, GL_RGB,
                   GL_FLOAT, image.row(face * edge).data());
    }
  }
  const auto set = [&](GLenum name, int value) { glTexParameteri(target_, name, value); };
  set(GL_TEXTURE_MAX_LEVEL, static_cast<int>(texture.levels.size()) - 1);
  set(GL_TEXTURE_MIN_FILTER, texture.levels.size() > 1 ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
  set(GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  set(GL_TEXTURE_WRAP_S, texture.repeats_x ? GL_REPEAT : GL_CLAMP_TO_EDGE);
  set(GL_TEXTURE_WRAP_T, texture.repeats_y ? GL_REPEAT : GL_CLAMP_TO_EDGE);
}

GpuTexture::~GpuTexture() {
  if (id_ != 0) glDeleteTextures(1, &id_);
}

void GpuTexture::bind(int unit) const {
  glActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
  glBindTexture(target_, id_);
}

}  // namespace zonal
