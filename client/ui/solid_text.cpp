#include "client/ui/solid_text.h"

#include <array>
#include <cstddef>

namespace platon {

std::string textOf(SolidKind solid) {
  // In the order of SolidKind.
  static constexpr std::array<const char*, kSolidKinds> kTexts = {
      "Tetrahedron · fire", "Cube · earth", "Octahedron · air", "Dodecahedron · ether", "Icosahedron · water"};
  return kTexts[static_cast<std::size_t>(solid)];
}

}  // namespace platon
