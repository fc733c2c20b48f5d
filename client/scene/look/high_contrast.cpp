#include "client/scene/look/high_contrast.h"

#include <cmath>

#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

namespace platon {
namespace {

constexpr float kGamma = 2.2F;
constexpr float kShare = 0.08F;  // of the light of a face that is left

}  // namespace

Scheme highContrast(const Scheme& scheme) {
  Scheme plain;
  for (std::size_t i = 0; i < plain.tones.size(); ++i) plain.tones[i] = highContrastFace(scheme.tones[i]);
  plain.skyTop = plain.skyBottom = plain.glow = Colour(0);
  return plain;
}

Colour highContrastFace(Colour face) {
  const float light = glm::dot(glm::pow(face, Colour(kGamma)), Colour(0.2126F, 0.7152F, 0.0722F));
  return Colour(std::pow(kShare * light, 1 / kGamma));
}

}  // namespace platon
