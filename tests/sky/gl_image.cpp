#include "tests/sky/gl_image.h"

#include <stdexcept>

#include <epoxy/egl.h>
#include <epoxy/gl.h>

namespace offing::test {
namespace {

void require(bool holds, const std::string& what) {
  if (!holds) throw std::runtime_error(what);
}

// Covers the picture with one triangle, without buffers.
constexpr const char* vertex_source = R"(#version 330 core
void main() {
  vec2 corner = vec2((gl_VertexID & 1) * 4 - 1, (gl_VertexID & 2) * 2 - 1);
  gl_Position = vec4(corner, 0.0, 1.0);
}
)";

GLuint compiled(GLenum stage, const std::string& source) {
  const GLuint shader = glCreateShader(stage);
  const char* text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint is_good = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &is_good);
  std::string log(4096, '\0');
  glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
  require(is_good == GL_TRUE, "shader: " + log);
  return shader;
}

GLuint linked(const std::string& fragment) {
  const GLuint program = glCreateProgram();
  glAttachShader(program, compiled(GL_VERTEX_SHADER, vertex_source));
  glAttachShader(program, compiled(GL_FRAGMENT_SHADER, fragment));
  glLinkProgram(program);
  GLint is_good = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &is_good);
  require(is_good == GL_TRUE, "the program does not link");
  return program;
}

void bind_texture(int unit, int width, int height, const void* texels) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, texels);
}

}  // namespace

// Everything made in the context goes with it.
struct GlImage::Context {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;

  Context() {
    require(epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"),
            "EGL has no surfaceless platform");
    display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    require(display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE,
            "EGL does not start");
    eglBindAPI(EGL_OPENGL_API);
    const EGLint wish[] = {EGL_CONTEXT_MAJOR_VERSION,
                           3,
                           EGL_CONTEXT_MINOR_VERSION,
                           3,
                           EGL_CONTEXT_OPENGL_PROFILE_MASK,
                           EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                           EGL_NONE};
    context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wish);
    if (context == EGL_NO_CONTEXT) {
      eglTerminate(display);
      throw std::runtime_error("no OpenGL 3.3 core context");
    }
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
  }
  ~Context() {
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, context);
    eglTerminate(display);
  }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
};

GlImage::GlImage(int width, int height)
    : context_(std::make_unique<Context>()), width_(width), height_(height) {
  GLuint framebuffer = 0, picture = 0, vertices = 0;
  glGenVertexArrays(1, &vertices);
  glBindVertexArray(vertices);
  glGenRenderbuffers(1, &picture);
  glBindRenderbuffer(GL_RENDERBUFFER, picture);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, width, height);
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, picture);
  require(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE,
          "RGBA32F cannot be painted on");
  glViewport(0, 0, width, height);
}

GlImage::~GlImage() = default;

std::string GlImage::renderer() const {
  const auto text = [](GLenum name) { return std::string(reinterpret_cast<const char*>(glGetString(name))); };
  return text(GL_RENDERER) + ", " + text(GL_VERSION);
}

std::vector<GlTexel> GlImage::paint(const std::string& fragment, const std::string& block_name,
                                    std::span<const std::byte> block,
                                    const std::vector<Table>& tables) const {
  const GLuint program = linked(fragment);
  glUseProgram(program);
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBufferBase(GL_UNIFORM_BUFFER, 0, buffer);
  glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(block.size()), block.data(), GL_STATIC_DRAW);
  const GLuint index = glGetUniformBlockIndex(program, block_name.c_str());
  require(index != GL_INVALID_INDEX, "no uniform block " + block_name);
  GLint block_bytes = 0;
  glGetActiveUniformBlockiv(program, index, GL_UNIFORM_BLOCK_DATA_SIZE, &block_bytes);
  require(static_cast<std::size_t>(block_bytes) == block.size(), "the block has another size in GLSL");
  glUniformBlockBinding(program, index, 0);
  int unit = 0;
  for (const Table& table : tables) {
    bind_texture(unit, table.columns, static_cast<int>(table.texels.size()) / table.columns,
                 table.texels.data());
    glUniform1i(glGetUniformLocation(program, table.sampler.c_str()), unit++);
  }
  glDrawArrays(GL_TRIANGLES, 0, 3);
  std::vector<GlTexel> texels(static_cast<std::size_t>(width_ * height_));
  glReadPixels(0, 0, width_, height_, GL_RGBA, GL_FLOAT, texels.data());
  require(glGetError() == GL_NO_ERROR, "OpenGL reports an error");
  return texels;
}

}  // namespace offing::test
