#pragma once

#include <bitset>
#include <span>
#include <string>

#include "client/ui/controls/bindings.h"

namespace platon {

/// The bindings as lines `key CONTROL KEY…` of the settings file, `none` for no key.
std::string textOf(const Bindings& bindings);

/// Reads such lines, in any order. A line takes its keys over from controls that have no line before it.
class BindingsReader {
 public:
  /// Gives the control of a line these keys, which are the words after it. Returns what is wrong with them, and changes
  /// nothing then; else an empty text.
  std::string read(Control control, std::span<const std::string> words);

  const Bindings& bindings() const { return bindings_; }

 private:
  std::string faultOf(Control control, const ControlKeys& keys) const;

  Bindings bindings_;
  std::bitset<kControlCount> read_;  // the controls that had a line
};

}  // namespace platon
