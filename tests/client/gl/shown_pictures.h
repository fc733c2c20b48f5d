#pragma once

#include <cstddef>
#include <functional>

#include "client/gl/image.h"

namespace platon {

/// In a program that links shown_pictures.cpp: how many pictures its windows have shown.
inline std::size_t shownPictures = 0;

/// Called before each of them is shown, while it is in the back buffer; empty: nothing.
inline std::function<void()> onPicture;

/// The picture that the window of the current context is about to show.
Image backBuffer();

}  // namespace platon
