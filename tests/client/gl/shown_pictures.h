#pragma once

#include <cstddef>
#include <functional>

namespace platon {

/// In a program that links shown_pictures.cpp: how many pictures its windows have shown.
inline std::size_t shownPictures = 0;

/// Called before each of them is shown, while it is in the back buffer; empty: nothing.
inline std::function<void()> onPicture;

}  // namespace platon
