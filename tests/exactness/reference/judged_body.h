#pragma once

#include "tests/exactness/reference/rational_vec.h"

namespace platon::reference {

/// A body on the lattice whose distance from the ideal one is measured.
class JudgedBody {
 public:
  virtual ~JudgedBody() = default;

  virtual void tick() = 0;
  /// The lattice position.
  virtual RationalVec position() const = 0;
  /// The position and its remainder.
  virtual RationalVec precisePosition() const = 0;
};

}  // namespace platon::reference
