#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "client/gl/gl_objects.h"
#include "client/gl/shader_program.h"
#include "client/gl/text_painter.h"
#include "client/ui/overlay.h"

namespace platon {

/// Draws overlays on top of the scene.
class OverlayPainter {
 public:
  OverlayPainter();

  /// `aspect` is the ratio of width to height of the picture.
  void draw(const Overlay& overlay, float aspect, TextPainter& text);

 private:
  struct Vertex {
    glm::vec2 place;
    glm::vec2 fromMiddle;
    glm::vec3 form;
    glm::vec4 colour;
  };

  void add(const Overlay::Panel& panel);
  void drawPanels(const Overlay& overlay, const glm::mat4& toClip);

  ShaderProgram program_;
  VertexStream<Vertex> stream_;
  std::vector<Vertex> vertices_;
};

}  // namespace platon
