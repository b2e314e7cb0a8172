#include "tests/gl/context.h"

#include <array>
#include <stdexcept>

namespace zonal {
namespace {

void require(bool ok, const std::string& what) {
  if (!ok) throw std::runtime_error(what);
}

std::string log_of(GLuint shader) {
  std::array<char, 4096> text = {};
  glGetShaderInfoLog(shader, static_cast<GLsizei>(text.size()), nullptr, text.data());
  return text.data();
}

GLuint checked(GLuint shader) {
  GLint ok = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  require(ok == GL_TRUE, "a shader does not compile: " + log_of(shader));
  return shader;
}

GLuint compiled(GLenum stage, const std::string& text) {
  const GLuint shader = glCreateShader(stage);
  const char* begin = text.c_str();
  glShaderSource(shader, 1, &begin, nullptr);
  glCompileShader(shader);
  return checked(shader);
}

GLuint specialised(GLenum stage, std::span<const char> module) {
  const GLuint shader = glCreateShader(stage);
  glShaderBinary(1, &shader, GL_SHADER_BINARY_FORMAT_SPIR_V_ARB, module.data(), static_cast<GLsizei>(module.size()));
  glSpecializeShaderARB(shader, "main", 0, nullptr, nullptr);
  return checked(shader);
}

}  // namespace

GlContext::GlContext() {
  const EGLint wanted[] = {
      EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 1, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  require(epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"), "EGL knows no surfaceless display");
  display_ = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  require(display_ != EGL_NO_DISPLAY && eglInitialize(display_, nullptr, nullptr), "EGL does not start");
  require(eglBindAPI(EGL_OPENGL_API), "EGL has no OpenGL");
  context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted);
  require(context_ != EGL_NO_CONTEXT, "there is no OpenGL 4.1 core");
  require(eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_), "the context needs a surface");
}

GlContext::~GlContext() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
  eglTerminate(display_);
}

GlProgram::GlProgram(std::span<const GLuint> shaders) : id_(glCreateProgram()) {
  for (const GLuint shader : shaders) {
    glAttachShader(id_, shader);
    glDeleteShader(shader);
  }
  glLinkProgram(id_);
  GLint ok = 0;
  glGetProgramiv(id_, GL_LINK_STATUS, &ok);
  std::array<char, 4096> text = {};
  glGetProgramInfoLog(id_, static_cast<GLsizei>(text.size()), nullptr, text.data());
  require(ok == GL_TRUE, std::string("a program does not link: ") + text.data());
}

GlProgram::~GlProgram() {
  if (id_ != 0) glDeleteProgram(id_);
}

GlProgram GlProgram::from_glsl(const std::string& vertex, const std::string& fragment) {
  return GlProgram(std::array{compiled(GL_VERTEX_SHADER, vertex), compiled(GL_FRAGMENT_SHADER, fragment)});
}

GlProgram GlProgram::from_spirv(std::span<const char> vertex, std::span<const char> fragment) {
  return GlProgram(std::array{specialised(GL_VERTEX_SHADER, vertex), specialised(GL_FRAGMENT_SHADER, fragment)});
}

std::vector<float> clip_from_pixel(int height) {
  return {2.0f / kGlWidth, 0, 0, 0, 0, 2.0f / static_cast<float>(height), 0, 0, 0, 0, 1, 0, -1, -1, 0, 1};
}

std::vector<std::vector<GlColor>> draw_points(const GlProgram& program, const std::vector<Vec3>& normals, int targets) {
  const int count = static_cast<int>(normals.size()), height = (count + kGlWidth - 1) / kGlWidth;
  std::vector<float> attributes;
  for (int i = 0; i < count; ++i) {
    const Vec3 n = normals[static_cast<std::size_t>(i)];
    const float x = static_cast<float>(i % kGlWidth) + 0.5f, y = static_cast<float>(i / kGlWidth) + 0.5f;
    attributes.insert(attributes.end(),
                      {x, y, 0, 1, static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z), 5});
  }
  GLuint frame = 0, array = 0, buffer = 0;
  std::vector<GLuint> pictures(static_cast<std::size_t>(targets));
  std::vector<GLenum> outputs;
  glGenFramebuffers(1, &frame);
  glBindFramebuffer(GL_FRAMEBUFFER, frame);
  glGenTextures(targets, pictures.data());
  for (int t = 0; t < targets; ++t) {
    outputs.push_back(static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + t));
    glBindTexture(GL_TEXTURE_2D, pictures[static_cast<std::size_t>(t)]);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, kGlWidth, height, 0, GL_RGBA, GL_FLOAT, nullptr);
    glFramebufferTexture2D(GL_FRAMEBUFFER, outputs.back(), GL_TEXTURE_2D, pictures[static_cast<std::size_t>(t)], 0);
  }
  glDrawBuffers(targets, outputs.data());
  require(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE, "no float pictures to draw into");

  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(attributes.size() * sizeof(float)), attributes.data(),
               GL_STATIC_DRAW);
  for (GLuint slot = 0; slot < 2; ++slot) {
    glEnableVertexAttribArray(slot);
    glVertexAttribPointer(slot, 4, GL_FLOAT, GL_FALSE, 8 * sizeof(float),
                          reinterpret_cast<const void*>(slot * 4 * sizeof(float)));
  }
  glViewport(0, 0, kGlWidth, height);
  glClearColor(-1e9f, -1e9f, -1e9f, -1e9f);  // a point that is not drawn must not pass for anything
  glClear(GL_COLOR_BUFFER_BIT);
  glUseProgram(program.id());
  glDrawArrays(GL_POINTS, 0, count);

  std::vector<std::vector<GlColor>> drawn;
  for (const GLenum output : outputs) {
    std::vector<GlColor>& picture = drawn.emplace_back(static_cast<std::size_t>(kGlWidth * height));
    glReadBuffer(output);
    glReadPixels(0, 0, kGlWidth, height, GL_RGBA, GL_FLOAT, picture.data());
    picture.resize(normals.size());
  }
  glDeleteBuffers(1, &buffer);
  glDeleteVertexArrays(1, &array);
  glDeleteFramebuffers(1, &frame);
  glDeleteTextures(targets, pictures.data());
  require(glGetError() == GL_NO_ERROR, "OpenGL reports an error");
  return drawn;
}

}  // namespace zonal
