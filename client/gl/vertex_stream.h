#pragma once

#include <cstddef>
#include <vector>

#include "client/gl/draw_calls.h"
#include "client/gl/gl_handle.h"

namespace platon {

/// A vertex array whose vertices are replaced before each draw call. `Vertex` is a struct of floats.
template <class Vertex>
class VertexStream {
 public:
  /// Reads `size` floats at `offset` of each vertex as the shader's attribute `index`.
  void attribute(GLuint index, GLint size, std::size_t offset) {
    bind();
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, sizeof(Vertex), bufferOffset(offset));
  }

  /// Draws triangles of three vertices each with the current program.
  void drawTriangles(const std::vector<Vertex>& vertices) {
    bind();
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)), vertices.data(),
                 GL_STREAM_DRAW);
    DrawCalls::arrays(GL_TRIANGLES, static_cast<GLsizei>(vertices.size()));
  }

 private:
  void bind() const {
    glBindVertexArray(array_.name());
    glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  }

  GlVertexArray array_;
  GlBuffer buffer_;
};

}  // namespace platon
