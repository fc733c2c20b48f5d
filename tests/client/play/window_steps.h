#pragma once

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include <GLFW/glfw3.h>

namespace platon {

/// One step of a test in a window: does something once, then waits until a condition holds.
struct WindowStep {
  std::function<void()> act;
  std::function<bool()> until;
};

inline bool windowHas(int attribute) { return glfwGetWindowAttrib(glfwGetCurrentContext(), attribute) == GLFW_TRUE; }

/// Runs a program in its window until all steps are done, or until it ends by itself. The first step begins when the
/// window has the focus. Returns whether all steps were done.
template <class Program>
bool runSteps(Program& program, std::vector<WindowStep> steps) {
  steps.insert(steps.begin(), {[] {}, [] { return windowHas(GLFW_FOCUSED); }});
  std::size_t next = 0;
  bool acted = false;
  program.run([&] {
    if (next == steps.size()) return true;
    if (!std::exchange(acted, true)) steps[next].act();
    if (steps[next].until()) {
      ++next;
      acted = false;
    }
    return false;
  });
  return next == steps.size();
}

}  // namespace platon
