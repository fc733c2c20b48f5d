#pragma once

#include "client/ui/controls/key_hints.h"
#include "client/ui/overlay_writer.h"

namespace platon {

/// Adds the table of keys, buttons and their meaning at the lower left. `brief`: with one key or button of each
/// control.
void addHelp(OverlayWriter& writer, const KeyHints& keys, bool brief);

}  // namespace platon
