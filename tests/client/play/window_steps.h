#pragma once

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

namespace platon {

/// One step of a test in a window: does something once, then waits until a condition holds.
struct WindowStep {
  std::function<void()> act;
  std::function<bool()> until;
};

inline bool windowHas(int attribute) { return glfwGetWindowAttrib(glfwGetCurrentContext(), attribute) == GLFW_TRUE; }

/// Runs a program in its window until all steps are done, or until it ends by itself. The first step begins when the
/// window has the focus. Returns whether all steps were done, and else the number of the step that was not,
/// from 1 on; 0: the window never had the focus.
template <class Program>
testing::AssertionResult runSteps(Program& program, std::vector<WindowStep> steps) {
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
  if (next == steps.size()) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "the program ended at step " << next << " of " << steps.size() - 1;
}

}  // namespace platon
