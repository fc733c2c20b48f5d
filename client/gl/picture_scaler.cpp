#include "client/gl/picture_scaler.h"

#include "client/gl/draw_calls.h"

namespace platon {

PictureScaler::PictureScaler() : program_("picture") {}

void PictureScaler::draw(const GlTexture& picture) {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, picture.name());
  program_.use();
  program_.set("picture", 0);
  glBindVertexArray(array_.name());
  DrawCalls::arrays(GL_TRIANGLE_STRIP, 4);
  glEnable(GL_BLEND);
}

}  // namespace platon
