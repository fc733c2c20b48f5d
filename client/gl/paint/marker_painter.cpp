#include "client/gl/paint/marker_painter.h"

#include <cstddef>

#include "client/gl/draw_calls.h"
#include "client/gl/paint/face_program.h"
#include "client/gl/shader_text.h"

namespace platon {
namespace {

ShaderProgram programOf(const char* fragments) { return {shaderText("marker.vert"), shaderText(fragments)}; }

}  // namespace

// A program for each kind: drivers that draw with the processor execute all branches of a shader.
MarkerPainter::MarkerPainter()
    : programs_{programOf("goal.frag"),   programOf("burst.frag"), programOf("start.frag"), programOf("sign.frag"),
                programOf("shadow.frag"), programOf("edge.frag"),  programOf("arrow.frag")} {}

void MarkerPainter::draw(const StageModel& stage, const FaceView& view, const Marker& marker, const Look& look) {
  const auto here = markerOn(stage.mesh, view.face, marker, double{look.reach});
  if (!here) return;
  ShaderProgram& program = programs_[static_cast<std::size_t>(look.kind)];
  useOnFace(program, stage, view);
  program.set("centre", here->place);
  program.set("angle", static_cast<float>(here->angle));
  program.set("radius", look.radius);
  program.set("reach", glm::vec2(look.reach, look.reach * look.height));
  program.set("opened", look.opened);
  program.set("seconds", look.seconds);
  program.set("form", look.form);
  glBindVertexArray(array_.name());
  DrawCalls::arrays(GL_TRIANGLE_STRIP, 4);
}

}  // namespace platon
