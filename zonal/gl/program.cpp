#include "zonal/gl/program.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include "zonal/base/check.h"
#include "zonal/base/error.h"

namespace zonal {
namespace {

[[noreturn]] void fail(std::string_view what, const std::string& log) {
  throw Error(ErrorKind::kUsage, fmt::format("the graphics driver refuses the shaders of '{}': {}", what, log),
              "choose another technique, or update the driver");
}

std::uint32_t compiled(std::uint32_t kind, const std::string& source, std::string_view what) {
  const std::uint32_t shader = glCreateShader(kind);
  const char* text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  int ok = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  if (ok) return shader;
  char log[2000] = {};
  glGetShaderInfoLog(shader, sizeof(log), nullptr, log);
  glDeleteShader(shader);
  fail(what, log);
}

}  // namespace

GpuProgram::GpuProgram(const std::string& vertex, const std::string& fragment, std::string_view what) {
  const std::uint32_t first = compiled(GL_VERTEX_SHADER, vertex, what);
  std::uint32_t second = 0;
  try {
    second = compiled(GL_FRAGMENT_SHADER, fragment, what);
  } catch (...) {
    glDeleteShader(first);
    throw;
  }
  id_ = glCreateProgram();
  glAttachShader(id_, first);
  glAttachShader(id_, second);
  glLinkProgram(id_);
  glDeleteShader(first);
  glDeleteShader(second);
  int ok = 0;
  glGetProgramiv(id_, GL_LINK_STATUS, &ok);
  if (ok) return;
  char log[2000] = {};
  glGetProgramInfoLog(id_, sizeof(log), nullptr, log);
  glDeleteProgram(id_);
  fail(what, log);
}

GpuProgram::~GpuProgram() {
  if (id_ != 0) glDeleteProgram(id_);
}

void GpuProgram::use() const { glUseProgram(id_); }

bool GpuProgram::has(const char* name) const { return glGetUniformLocation(id_, name) >= 0; }

void GpuProgram::set(const char* name, int value) const { glUniform1i(glGetUniformLocation(id_, name), value); }
void GpuProgram::set(const char* name, float value) const { glUniform1f(glGetUniformLocation(id_, name), value); }

void GpuProgram::set_vectors(const char* name, int components, std::span<const float> values) const {
  const int place = glGetUniformLocation(id_, name);
  const int count = static_cast<int>(values.size()) / components;
  switch (components) {
    case 1:
      return glUniform1fv(place, count, values.data());
    case 2:
      return glUniform2fv(place, count, values.data());
    case 3:
      return glUniform3fv(place, count, values.data());
    case 4:
      return glUniform4fv(place, count, values.data());
    default:
      check(false, "vectors have one to four components");
  }
}

void GpuProgram::set_matrix(const char* name, std::span<const float> columns) const {
  const int place = glGetUniformLocation(id_, name);
  check(columns.size() == 9 || columns.size() == 16, "a matrix of 3 x 3 or 4 x 4");
  if (columns.size() == 9) {
    glUniformMatrix3fv(place, 1, GL_FALSE, columns.data());
  } else {
    glUniformMatrix4fv(place, 1, GL_FALSE, columns.data());
  }
}

}  // namespace zonal
