#include "client/gl/picture_fade.h"

#include "client/gl/colour_texture.h"
#include "client/gl/draw_calls.h"
#include "client/gl/shader_text.h"

namespace platon {

PictureFade::PictureFade() : program_(shaderText("picture.vert"), shaderText("fade.frag")) {}

void PictureFade::keep(const RenderTarget& target) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  attachColour(picture_, target.width(), target.height());
  target.copyTo(framebuffer_);
}

void PictureFade::draw(double opacity) {
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, picture_.name());
  program_.use();
  program_.set("picture", 0);
  program_.set("opacity", static_cast<float>(opacity));
  glBindVertexArray(array_.name());
  DrawCalls::arrays(GL_TRIANGLE_STRIP, 4);
}

}  // namespace platon
