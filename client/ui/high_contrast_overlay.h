#pragma once

#include "client/ui/overlay.h"

namespace platon {

/// Makes dark panels black and all panels opaque, and the colours of texts as bright as they can be.
void raiseContrast(Overlay& overlay);

}  // namespace platon
