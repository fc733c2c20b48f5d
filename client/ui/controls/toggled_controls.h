#pragma once

namespace platon {

/// Controls that a press turns on and the next press off; the others act while a key is held.
struct ToggledControls {
  bool slow = false;
  bool look = false;
};

}  // namespace platon
