#pragma once

namespace platon::shaders {

/// Elements of a level, each kind in its pattern.
extern const char* const kElementVertex;
/// Needs kInk before it.
extern const char* const kElementFragment;

}  // namespace platon::shaders
