#include "server/base/line_buffer.h"

#include <algorithm>

namespace platon {

std::optional<std::string> LineBuffer::next() {
  if (!ready()) return std::nullopt;
  const std::size_t end = bytes_.find('\n');
  std::string line = bytes_.substr(0, end);
  bytes_.erase(0, end + 1);
  if (line.ends_with('\r')) line.pop_back();
  return line;
}

bool LineBuffer::ready() const { return bytes_.find('\n') <= maxBytes_; }

bool LineBuffer::tooLong() const { return std::min(bytes_.find('\n'), bytes_.size()) > maxBytes_; }

}  // namespace platon
