"""Faults in lists of servers, from the file of the server to the search of the client."""

from fault import Fault, at_length

LIST = "protocol/transport/server_list.cpp"
SEARCH = "client/lobby/listed_servers.cpp"

LIST_FAULTS = [
    at_length("redirected-into-the-network", "client/lobby/download.cpp",
              "if (redirections == 0) {", "if (redirections >= 0) {",
              "a web server makes those who read its list ask other machines of their network",
              "DownloadTest.LeadsOnlyWhereItMay"),
    Fault("list-without-signatures", LIST,
          "!isSignature(*signature, signedText(server.address, server.name), *key)", "signedText(server.address, "
          "server.name).empty()",
          "anybody can list a server under a key that is not its own",
          "ServerListTest.NobodyListsAServerUnderAKeyThatItDoesNotHave"),
    at_length("name-is-not-signed", LIST,
              'address.text() + "\\n" + std::string(name)', 'address.text() + "\\n" + std::string(name.substr(0, 0))',
              "who makes a list can rename its servers",
              "ServerListTest.NobodyListsAServerUnderAKeyThatItDoesNotHave"),
    at_length("twins-with-other-keys", LIST,
              "other.address.text() == address;", "other.address.text() == address && other.key == server.key;",
              "two servers of a list have one address",
              "ServerListTest.TwoServersAtOneAddressAreOneTooMany"),
    at_length("list-nested-deeper", LIST, "(begins && depth >= kMaxDepth)", "(begins && depth > kMaxDepth)",
              "a list is refused only where it is nested one level deeper than is kept",
              "ServerListTest.AListThatIsNestedTooDeeplyIsRefused"),
    at_length("answer-under-any-key", SEARCH, " && target.listed.key == info->identity", "",
              "a server in the place of the listed one is shown under its name",
              "ListedSearchTest.OnlyTheServerThatWasAskedAnswersUnderItsKey"),
    at_length("answer-to-another-query", SEARCH, "target.nonce == info->nonce && ", "",
              "a server answers for another one that has its key",
              "ListedSearchTest.OnlyTheServerThatWasAskedAnswersUnderItsKey"),
    at_length("silent-servers-asked-for-ever", SEARCH, "(target.found || target.tries < kMaxTries) && ", "",
              "a list sends its readers to a victim for ever",
              "ListedSearchTest.AListIsNoFlood"),
    at_length("one-machine-asked-too-often", SEARCH,
              "neighbours >= kMaxPerHousehold", "neighbours > kMaxPerHousehold",
              "a list has more servers of one machine asked than it may",
              "ListedSearchTest.AskedForOneMachineItAsksAtMost16Servers"),
    at_length("own-machine-in-any-list", SEARCH, " && !allowsLoopback_", " && allowsLoopback_",
              "a list from elsewhere has its readers send to their own machines",
              "ListedSearchTest.RefusesAddressesThatAreNotOfOneOtherMachine"),
    at_length("list-for-its-owner-only", "protocol/files/file_replacement.cpp",
              "Readers::kAllIfNew ? 0644 : 0600", "Readers::kAllIfNew ? 0600 : 0600",
              "no web server can publish the list",
              "TextFileTest.OnlyAPublicFileCanBeReadByOthersWhenItIsNew"),
    at_length("entry-written-again", "server/admin/announcement.cpp",
              "wanted == std::vector{*before}) return kept;", "wanted == std::vector{*before} && wanted.empty()) return kept;",
              "each reload waits for the disk",
              "AnnouncementTest.AFileThatHoldsTheEntryIsNotWrittenAgain"),
]  # fmt: skip
