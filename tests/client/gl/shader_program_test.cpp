#include "client/gl/shader_program.h"

#include <array>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "client/gl/gl_context.h"
#include "client/gl/gl_objects.h"
#include "client/gl/render_target.h"

namespace platon::shader_program_test {
namespace {

constexpr const char* kVertex = R"(
void main() {
  gl_Position = vec4((gl_VertexID & 1) * 4 - 1, (gl_VertexID >> 1) * 4 - 1, 0, 1);
}
)";

class ShaderProgramTest : public testing::Test {
 protected:
  // The colour that the expression gives, with components in 0 … 255.
  std::vector<std::uint8_t> drawn(ShaderProgram& program) {
    const RenderTarget target(1, 1, 1);
    const GlVertexArray array;
    target.bindSampled();
    glBindVertexArray(array.name());
    program.use();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    target.resolve();
    EXPECT_EQ(takeGlErrors(), "");
    return target.read().pixels;
  }

  static std::string fragment(const std::string& declarations, const std::string& colour) {
    return declarations + "\nout vec4 result;\nvoid main() { result = vec4(" + colour + ", 1); }\n";
  }

  static std::string errorOf(const std::string& vertex, const std::string& source) {
    try {
      ShaderProgram program(vertex, source, "test");
      return "";
    } catch (const std::runtime_error& error) {
      return error.what();
    }
  }

  Offscreen context_;
};

TEST_F(ShaderProgramTest, UniformsAreSetByName) {
  ShaderProgram program(kVertex, fragment("uniform float a; uniform int b; uniform vec2 c;", "a, b, c.y"), "test");
  program.use();
  program.set("a", 0.2F);
  program.set("b", 1);
  program.set("c", glm::vec2(0, 0.4F));
  EXPECT_EQ(drawn(program), (std::vector<std::uint8_t>{51, 255, 102}));
  program.set("a", 1.0F);
  EXPECT_EQ(drawn(program), (std::vector<std::uint8_t>{255, 255, 102}));
}

TEST_F(ShaderProgramTest, VectorsMatricesAndArraysAreSetByName) {
  ShaderProgram program(
      kVertex,
      fragment("uniform vec3 a; uniform vec4 b; uniform mat4 c; uniform vec2 d[2];", "a.z, b.w * c[3][0], d[1].y"),
      "test");
  program.use();
  program.set("a", glm::vec3(0, 0, 0.2F));
  program.set("b", glm::vec4(0, 0, 0, 0.5F));
  glm::mat4 matrix(0);
  matrix[3][0] = 0.8F;
  program.set("c", matrix);
  program.set("d", std::array{glm::vec2(0), glm::vec2(0, 0.6F)});
  EXPECT_EQ(drawn(program), (std::vector<std::uint8_t>{51, 102, 153}));
}

TEST_F(ShaderProgramTest, AFileHoldsThePartsThatItIncludes) {
  const std::string& text = shaderText("mark.frag");
  EXPECT_NE(text.find("float depthInFace("), std::string::npos) << text;
  EXPECT_EQ(text.find("#include"), std::string::npos) << text;
  EXPECT_THROW(shaderText("nothing.frag"), std::logic_error);
}

TEST_F(ShaderProgramTest, ErrorsHaveTheMessageOfTheDriver) {
  const std::string syntax = errorOf(kVertex, "void main() { nonsense; }");
  EXPECT_EQ(syntax.find("cannot compile the fragment shader of test: "), 0U) << syntax;
  EXPECT_NE(syntax.find("nonsense"), std::string::npos) << syntax;
  const std::string vertex = "out vec2 tone;\nvoid main() { tone = vec2(0); gl_Position = vec4(0); }\n";
  const std::string link = errorOf(vertex, fragment("in vec3 tone;", "tone"));
  EXPECT_EQ(link.find("cannot link the shaders of test: "), 0U) << link;
  takeGlErrors();
}

}  // namespace
}  // namespace platon::shader_program_test
