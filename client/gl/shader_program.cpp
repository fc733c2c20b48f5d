#include "client/gl/shader_program.h"

#include <array>
#include <stdexcept>
#include <string_view>

namespace platon {
namespace {

constexpr const char* kVersionLine = "#version 330 core\n";

GLuint compiled(GLenum kind, const std::string& source, const std::string& name) {
  const GLuint shader = glCreateShader(kind);
  const std::array<const char*, 2> parts{kVersionLine, source.c_str()};
  glShaderSource(shader, static_cast<GLsizei>(parts.size()), parts.data(), nullptr);
  glCompileShader(shader);
  GLint succeeded = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &succeeded);
  if (succeeded == GL_TRUE) return shader;
  std::array<char, 2048> message{};
  glGetShaderInfoLog(shader, static_cast<GLsizei>(message.size()), nullptr, message.data());
  glDeleteShader(shader);
  throw std::runtime_error("cannot compile " + name + ": " + message.data());
}

}  // namespace

ShaderProgram::ShaderProgram(const std::string& name)
    : ShaderProgram(shaderText(name + ".vert"), shaderText(name + ".frag"), name) {}

ShaderProgram::ShaderProgram(const std::string& vertex, const std::string& fragment, const std::string& name) {
  const GLuint first = compiled(GL_VERTEX_SHADER, vertex, "the vertex shader of " + name);
  const GLuint second = compiled(GL_FRAGMENT_SHADER, fragment, "the fragment shader of " + name);
  name_ = glCreateProgram();
  glAttachShader(name_, first);
  glAttachShader(name_, second);
  glLinkProgram(name_);
  glDeleteShader(first);
  glDeleteShader(second);
  GLint succeeded = GL_FALSE;
  glGetProgramiv(name_, GL_LINK_STATUS, &succeeded);
  if (succeeded == GL_TRUE) return;
  std::array<char, 2048> message{};
  glGetProgramInfoLog(name_, static_cast<GLsizei>(message.size()), nullptr, message.data());
  glDeleteProgram(name_);
  throw std::runtime_error("cannot link the shaders of " + name + ": " + message.data());
}

ShaderProgram::~ShaderProgram() { glDeleteProgram(name_); }

GLint ShaderProgram::location(const char* uniform) {
  const auto known = locations_.find(std::string_view(uniform));
  if (known != locations_.end()) return known->second;
  return locations_.emplace(uniform, glGetUniformLocation(name_, uniform)).first->second;
}

}  // namespace platon
