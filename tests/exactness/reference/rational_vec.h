#pragma once

#include <gmpxx.h>

namespace platon::reference {

/// A point or vector with rational coordinates of any size.
struct RationalVec {
  mpq_class x;
  mpq_class y;
};

}  // namespace platon::reference
