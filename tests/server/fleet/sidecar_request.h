#pragma once

#include <map>
#include <string>

namespace platon {

/// A request to the sidecar of Agones, as its published description allows it.
struct SidecarRequest {
  std::string method;
  std::string path;
  std::string text;  ///< of the body
  /// Properties of the body. All that the operations in use have are of type string and format int64.
  std::map<std::string, std::string> body;

  /// Reads a whole request of HTTP/1.0 or HTTP/1.1, head and body. Throws std::invalid_argument with a sentence if the
  /// description does not allow it.
  static SidecarRequest read(const std::string& request);
};

}  // namespace platon
