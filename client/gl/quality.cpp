#include "client/gl/quality.h"

#include <GL/glew.h>

namespace platon {

Quality qualityFor(std::string_view renderer) {
  Quality quality = kBestQuality;
  for (const std::string_view software : {"llvmpipe", "softpipe", "SWR", "Software"}) {
    if (renderer.find(software) != std::string_view::npos) quality.samples = 1;
  }
  return quality;
}

Quality defaultQuality() {
  const GLubyte* const renderer = glGetString(GL_RENDERER);
  return qualityFor(renderer == nullptr ? "" : reinterpret_cast<const char*>(renderer));
}

}  // namespace platon
