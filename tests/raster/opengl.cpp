// SPDX-License-Identifier: Apache-2.0
#include "tests/raster/opengl.hpp"

#include <cstring>
#include <stdexcept>

namespace halfspace::tests {
namespace {

// Positions span this many pixels on either side of the frame's corner: in units of 1/256 a float32 has them exactly,
// divided by it and multiplied again.
constexpr int kReach = 8192;

const char* const kVertexShader = R"(#version 450
layout(location = 0) in vec3 place;
void main() { gl_Position = vec4(place, 1); }
)";

// Index k + 1 of the k-th triangle; fragment_hash(k).
const char* const kFragmentShader = R"(#version 450
layout(location = 0) out uint index;
layout(std430, binding = 0) buffer Sums { uint sum[]; };
layout(location = 0) uniform int width;
layout(location = 1) uniform bool adds;
void main() {
  uint k = uint(gl_PrimitiveID);
  index = k + 1u;
  if (adds) {
    uint h = k * 2654435761u + 0x9e3779b9u;
    h ^= h >> 16; h *= 0x85ebca6bu; h ^= h >> 13;
    int at = 2 * (int(gl_FragCoord.y) * width + int(gl_FragCoord.x));
    atomicAdd(sum[at], h);
    atomicAdd(sum[at + 1], 1u);
  }
}
)";

[[noreturn]] void refuse(const std::string& what) {
  throw std::runtime_error("OpenGL: " + what +
                           ": install a driver of the GPU, or libegl1 and libgl1-mesa-dri for Mesa's llvmpipe");
}

GLuint shader(GLenum kind, const char* text) {
  const GLuint made = glCreateShader(kind);
  glShaderSource(made, 1, &text, nullptr);
  glCompileShader(made);
  GLint done = 0;
  glGetShaderiv(made, GL_COMPILE_STATUS, &done);
  if (!done) {
    char log[1024] = "";
    glGetShaderInfoLog(made, sizeof log, nullptr, log);
    refuse(std::string("it does not compile a shader of version 4.5: ") + log);
  }
  return made;
}

GLuint linked_program() {
  const GLuint program = glCreateProgram();
  glAttachShader(program, shader(GL_VERTEX_SHADER, kVertexShader));
  glAttachShader(program, shader(GL_FRAGMENT_SHADER, kFragmentShader));
  glLinkProgram(program);
  GLint done = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &done);
  if (!done) refuse("it does not link the shaders");
  return program;
}

// Devices first, of which the GPU's is the first; then Mesa without a surface.
std::vector<EGLDisplay> displays() {
  std::vector<EGLDisplay> found;
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration") ||
      epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_base")) {
    EGLDeviceEXT devices[16];
    EGLint count = 0;
    if (eglQueryDevicesEXT(16, devices, &count)) {
      for (EGLint n = 0; n < count; ++n) {
        found.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[n], nullptr));
      }
    }
  }
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
    found.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  }
  return found;
}

}  // namespace

OpenGl::OpenGl(int width, int height) : width_(width), height_(height) {
  make_context();
  renderer_ = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  renderer_ += std::string(", OpenGL ") + reinterpret_cast<const char*>(glGetString(GL_VERSION));
  glGetIntegerv(GL_SUBPIXEL_BITS, &subpixel_bits_);
  program_ = linked_program();
  glUseProgram(program_);
  glUniform1i(0, width);

  glGenTextures(1, &colour_);
  glBindTexture(GL_TEXTURE_2D, colour_);
  glTexStorage2D(GL_TEXTURE_2D, 1, GL_R32UI, width, height);
  glGenRenderbuffers(1, &depth_);
  glBindRenderbuffer(GL_RENDERBUFFER, depth_);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, width, height);
  glGenFramebuffers(1, &framebuffer_);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_, 0);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    refuse("it has no frame of 32-bit indices with 32 bits of depth");
  }
  GLint most[2] = {0, 0};
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, most);
  if (most[0] < 2 * kReach || most[1] < 2 * kReach) refuse("its viewports have less than 16384 pixels");
  glViewport(-kReach, -kReach, 2 * kReach, 2 * kReach);
  glDisable(GL_CULL_FACE);
  glDepthFunc(GL_LESS);

  glGenVertexArrays(1, &array_);
  glBindVertexArray(array_);
  glGenBuffers(1, &vertices_);
  glBindBuffer(GL_ARRAY_BUFFER, vertices_);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  glEnableVertexAttribArray(0);
  glGenBuffers(1, &sums_);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, sums_);
  glBufferData(GL_SHADER_STORAGE_BUFFER, GLsizeiptr(sizeof(std::uint32_t)) * 2 * width * height, nullptr,
               GL_DYNAMIC_READ);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, sums_);
  calibrate();
}

OpenGl::~OpenGl() { release(); }

void OpenGl::release() {
  if (context_ == EGL_NO_CONTEXT) return;
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
  context_ = EGL_NO_CONTEXT;
}

void OpenGl::make_context() {
  const EGLint attributes[] = {
      EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 5, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  for (const EGLDisplay display : displays()) {
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API)) continue;
    display_ = display;
    context_ = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (context_ != EGL_NO_CONTEXT && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) return;
    release();
  }
  refuse("no display of EGL gives a context of version 4.5");
}

// Which way up memory has the tie rule: where an upper left edge through centres belongs to its triangle in row 0 on
// top.
void OpenGl::calibrate() {
  ref::SnappedList scene;
  scene.format.subpixel_bits = 8, scene.format.depth_bits = 24;
  scene.width = width_, scene.height = height_;
  ref::SnappedTriangle t{};
  // Its upper edge lies on the centres of row 0.
  t.x[0] = 0, t.y[0] = 128, t.x[1] = 4 * 256, t.y[1] = 128, t.x[2] = 0, t.y[2] = 128 + 4 * 256;
  scene.triangles = {t};
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  if (coverage(scene).sum[0] != 0) return;
  // gl_FragCoord and rows in memory stay; which edge a tie belongs to changes, with the sign of y.
  glClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
  if (coverage(scene).sum[0] == 0) refuse("no way of clip control draws an upper edge");
}

void OpenGl::draw(const ref::SnappedList& scene) {
  GLint origin = 0;
  glGetIntegerv(GL_CLIP_ORIGIN, &origin);
  const float one = float(kReach << scene.format.subpixel_bits), up = origin == GL_UPPER_LEFT ? -1.0f : 1.0f;
  const float depth = float(std::uint64_t(1) << scene.format.depth_bits);
  std::vector<float> places;
  places.reserve(9 * scene.triangles.size());
  for (const ref::SnappedTriangle& t : scene.triangles) {
    for (int v = 0; v < 3; ++v) {
      places.insert(places.end(), {float(t.x[v]) / one, up * float(t.y[v]) / one, float(t.depth[v]) / depth});
    }
  }
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(places.size() * sizeof(float)), places.data(), GL_STREAM_DRAW);
  const GLuint none[4] = {0, 0, 0, 0};
  const float far = float(ref::full_depth(scene.format.depth_bits)) / depth;  // which no fragment passes at
  glClearBufferuiv(GL_COLOR, 0, none);
  glClearBufferfv(GL_DEPTH, 0, &far);
  glDrawArrays(GL_TRIANGLES, 0, GLsizei(places.size() / 3));
  glFinish();
}

OpenGl::Coverage OpenGl::coverage(const ref::SnappedList& scene) {
  const std::size_t pixels = std::size_t(width_) * height_;
  std::vector<std::uint32_t> words(2 * pixels, 0);
  const GLsizeiptr bytes = GLsizeiptr(words.size() * sizeof(std::uint32_t));
  glBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, bytes, words.data());
  glUniform1i(1, 1);
  glDisable(GL_DEPTH_TEST);
  draw(scene);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, bytes, words.data());
  Coverage out;
  out.sum.resize(pixels);
  for (std::size_t at = 0; at < pixels; ++at) {
    out.sum[at] = words[2 * at];
    out.fragments += words[2 * at + 1];
  }
  return out;
}

OpenGl::Visible OpenGl::visible(const ref::SnappedList& scene) {
  const std::size_t pixels = std::size_t(width_) * height_;
  glUniform1i(1, 0);
  glEnable(GL_DEPTH_TEST);
  draw(scene);
  Visible out;
  out.index.resize(pixels), out.depth.resize(pixels);
  glReadPixels(0, 0, width_, height_, GL_RED_INTEGER, GL_UNSIGNED_INT, out.index.data());
  glReadPixels(0, 0, width_, height_, GL_DEPTH_COMPONENT, GL_FLOAT, out.depth.data());
  return out;
}

}  // namespace halfspace::tests
