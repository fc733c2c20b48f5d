#pragma once

#include <memory>
#include <string>
#include <vector>

#include "client/gl/gl_objects.h"
#include "client/gl/shader_program.h"
#include "client/gl/text_painter.h"
#include "client/scene/face_view.h"
#include "client/scene/scene.h"

namespace platon {

/// The constants by which the shader of the elements names their kinds: kind_oneway …, and their number kKinds.
std::string elementKindsOfShader();

/// Draws what is flat of the elements of a level. With elementWallsOf(), each kind has a pattern of its own, so that
/// colour is never the only sign:
///   oneway      a thin ledge; chevrons on the right side, from which it lets pass, point through it, and light fades
///   up          blocks with arrows that point to its edge; flat and hollow while it does not block the local player
///   hazard      a zigzag
///   checkpoint  dashes and a flag, which is filled where the local player returns to it
///   key         dots, and a key with its number; nothing once it is taken
///   door        two rails and its number; only their ends while it is open
///   plate       a wall with a bar on its left side, which is low while it is pressed, and its number
///   timed       a fence of posts, low while it is open, and a clock that empties while it is solid and fills while it
///               is open
/// Flags, keys, clocks and numbers stand upright for the local player.
class StageElementPainter {
 public:
  StageElementPainter();

  /// Draws what lies flat on a face, or with `raised` what lies on the walls of the elements. A face without elements
  /// has no draw call.
  void draw(const Scene& scene, const FaceView& view, bool raised, TextPainter& text);

 private:
  // An element for the shader.
  struct Instance {
    Ribbon ends;
    glm::vec2 look{0};  // towards its edge (of up), or how full its clock is and 0 (of timed)
    float kind = 0;
    float active = 0;
  };
  struct Part {
    GLsizei first = 0;
    GLsizei count = 0;
  };

  void load(const Scene& scene);
  void addNumbers(const Scene& scene, const FaceView& view, bool raised, glm::vec2 up, TextPainter& text) const;

  std::weak_ptr<const StageModel> stage_;  // that is loaded
  std::vector<std::uint8_t> active_;       // ElementStates::active that is loaded
  std::vector<float> clocks_;              // ElementStates::clocks that is loaded
  std::vector<Part> parts_;                // by face: its part of instances_
  ShaderProgram program_;
  GlVertexArray array_;
  GlBuffer instances_;
};

}  // namespace platon
