#pragma once

#include "client/menu/menu_item.h"
#include "client/quality/quality_choice.h"

namespace platon {

/// The items of a page that change `choice`, which outlives them. A level that is chosen takes the place of a render
/// scale and of samples that were.
MenuItem qualityItem(QualityChoice& choice);
MenuItem renderScaleItem(QualityChoice& choice);
MenuItem multisamplingItem(QualityChoice& choice);
/// An action: the level is to be chosen by measuring.
MenuItem measureItem(QualityChoice& choice);

}  // namespace platon
