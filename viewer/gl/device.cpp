// What the current OpenGL context is, and whether it serves us.
#include "gl/device.h"

#include <glad/gl.h>

#include <algorithm>

namespace isoscope::gl {
namespace {

std::string text(GLenum name) {
  const GLubyte* value = glGetString(name);
  return value ? std::string(reinterpret_cast<const char*>(value)) : std::string();
}

} // namespace

Result<Device> current_device() {
  const std::string remedy =
      "Update the graphics driver, or install Mesa's software renderer (libgl1-mesa-dri).";
  if (glGetString == nullptr) return Error{ErrorCode::device, "No OpenGL context is current.", remedy};
  Device device;
  device.renderer = text(GL_RENDERER);
  device.version = text(GL_VERSION);
  if (device.version.empty()) return Error{ErrorCode::device, "No OpenGL context is current.", remedy};
  GLint major = 0, minor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  if (major * 10 + minor < 41)
    return Error{ErrorCode::device,
                 "OpenGL 4.1 is needed; the driver " + device.renderer + " offers " + device.version + ".",
                 remedy};
  GLint samples = 0;
  glGetIntegerv(GL_MAX_SAMPLES, &samples);
  device.max_samples = samples;
  const auto is = [&](const char* name) { return device.renderer.find(name) != std::string::npos; };
  device.software = is("llvmpipe") || is("softpipe") || is("SWR") || is("Software");
  return device;
}

} // namespace isoscope::gl
