#pragma once

#include <string_view>

namespace platon {

/// The address in a link to a server, `platon://HOST[:PORT]`, with or without a slash at its end, as a browser hands it
/// to the program. A text that is no such link is returned as it is. The result need not be a valid address:
/// parseServerAddress refuses what is not one. It is a part of `text`.
std::string_view addressOfLink(std::string_view text);

}  // namespace platon
