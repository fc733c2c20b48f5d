#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace platon {

/// Whether the text can be shown on a screen and in a log unchanged: at most `maxBytes` bytes of valid UTF-8 without
/// control characters, line breaks or marks that change the direction of writing. The empty text is a label.
bool isLabel(std::string_view text, std::size_t maxBytes);

/// Combining characters that are shown on one letter, those of which it is composed in NFC included: accents, that is
/// those with a combining class and those that enclose, and vowel signs, that is all others. The marks of which a
/// letter is composed in NFC are always shown; some Greek letters have three accents.
inline constexpr std::size_t kMaxAccents = 2;
inline constexpr std::size_t kMaxVowelSigns = 4;

/// What a reader sees of a label: without invisible characters, such as those of width zero and unassigned ones;
/// without combining characters that have nothing to combine with, that repeat one on the same letter, or that are too
/// many in the order of NFC; with one plain space for each run of spaces, and none at the ends. Canonically equivalent
/// labels have canonically equivalent visible texts, except for letters with too many marks that are longer in NFC. Not
/// longer than the label. Empty if nothing of the label can be seen.
std::string visibleLabel(std::string_view label);

/// A key that is equal for labels that a reader takes for the same: what is visible of them after full case folding and
/// compatibility composition (NFKC) is the same text. So it does not tell apart capitals, composed and decomposed
/// letters, full-width letters, ligatures and superscripts.
std::string lookAlikeKey(std::string_view label);

}  // namespace platon
