#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>

#include <GL/glew.h>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace platon {

/// The text of a file in client/gl/shaders, "face.vert", with the parts that it includes: GLSL 3.30 without the
/// #version line. The build compiles the files into the program. Throws std::logic_error if there is no such file.
/// Colours are blended as sRGB values, without conversion to linear light.
const std::string& shaderText(std::string_view file);

/// A linked vertex and fragment shader, with access to the uniforms by name.
class ShaderProgram {
 public:
  /// The program of the files NAME.vert and NAME.frag in client/gl/shaders. Throws as below.
  explicit ShaderProgram(const std::string& name);
  /// Sources are GLSL 3.30 without the #version line. Throws std::runtime_error with the driver's message when they do
  /// not compile or link; `name` tells there whose shaders they are.
  ShaderProgram(const std::string& vertex, const std::string& fragment, const std::string& name);
  ~ShaderProgram();
  ShaderProgram(const ShaderProgram&) = delete;
  ShaderProgram& operator=(const ShaderProgram&) = delete;

  /// Makes this the program of the following draw calls and of `set`.
  void use() const { glUseProgram(name_); }

  void set(const char* uniform, int value) { glUniform1i(location(uniform), value); }
  void set(const char* uniform, float value) { glUniform1f(location(uniform), value); }
  void set(const char* uniform, const glm::vec2& value) { glUniform2fv(location(uniform), 1, &value[0]); }
  void set(const char* uniform, const glm::vec3& value) { glUniform3fv(location(uniform), 1, &value[0]); }
  void set(const char* uniform, const glm::vec4& value) { glUniform4fv(location(uniform), 1, &value[0]); }
  void set(const char* uniform, const glm::mat4& value) {
    glUniformMatrix4fv(location(uniform), 1, GL_FALSE, &value[0][0]);
  }
  /// `values` must not be empty.
  void set(const char* uniform, std::span<const glm::vec2> values) {
    glUniform2fv(location(uniform), static_cast<GLsizei>(values.size()), &values[0][0]);
  }

 private:
  GLint location(const char* uniform);

  GLuint name_ = 0;
  std::map<std::string, GLint, std::less<>> locations_;
};

}  // namespace platon
