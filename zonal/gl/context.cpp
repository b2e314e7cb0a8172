#include "zonal/gl/context.h"

#include <epoxy/egl.h>
#include <fmt/format.h>

#include "zonal/base/error.h"

namespace zonal {
namespace {

[[noreturn]] void fail(const char* what) {
  throw Error(ErrorKind::kUsage, fmt::format("no OpenGL without a display: {} (EGL error {:#x})", what, eglGetError()),
              "install Mesa's drivers (Debian: libegl1 libgl1-mesa-dri)");
}

}  // namespace

OffscreenContext::OffscreenContext() {
  EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) fail("no surfaceless display");
  display_ = display;
  if (!eglBindAPI(EGL_OPENGL_API)) fail("no OpenGL");
  constexpr EGLint kContext[] = {
      EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 1, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  context_ = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, kContext);
  if (context_ == EGL_NO_CONTEXT) fail("no context of version 4.1");
  if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) fail("the context cannot be used");
}

OffscreenContext::~OffscreenContext() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
  eglTerminate(display_);
}

}  // namespace zonal
