"""Faults in what is shown of names, and in what makes two names the same."""

from fault import at_length

PROTOCOL = "protocol/"
MATCH = "server/match/"

NAME_FAULTS = [
    at_length("accents-without-limit", PROTOCOL + "label.cpp",
              "if (accents > kMaxAccents || marks.size() - accents > kMaxVowelSigns) return false;",
              "if (accents > marks.size()) return false;",
              "a letter with any number of marks makes another name, and covers the lines around it",
              "Label.ALetterHasTwoAccents"),
    at_length("composed-accents-uncounted", PROTOCOL + "label.cpp",
              "marks_ = partsOf(code);", "marks_ = partsOf(isCombining(code) ? code : ' ');",
              "a composed letter has two accents more than its parts",
              "Label.ALetterHasTwoAccents"),
    at_length("compatibility-forms-differ", PROTOCOL + "label.cpp",
              "UTF8PROC_COMPOSE | UTF8PROC_COMPAT", "UTF8PROC_COMPOSE",
              "letters of full width and ligatures make other names",
              "PlayerNamesTest.NamesInOtherFormsOfUnicodeGetANumber"),
    at_length("order-of-marks-differs", PROTOCOL + "label.cpp",
              "mapped(visibleLabel(label), UTF8PROC_STABLE | UTF8PROC_DECOMPOSE)", "visibleLabel(label)",
              "marks in another order make another name",
              "Label.LabelsThatLookAlikeHaveTheSameKey"),
    at_length("invisible-name-nearby", "client/lobby/near_servers.cpp",
              "  info->name = visibleLabel(info->name);\n", "",
              "a server nearby with a name of width zero is a blank on the list",
              "NearServersTest.OfANameIsShownWhatCanBeSeen"),
    at_length("invisible-name-in-a-list", "client/lobby/listed_search.cpp",
              "  targets_.back().listed.name = visibleLabel(server.name);\n", "",
              "a server with a name of width zero is a blank in a list",
              "ListedSearchTest.OfANameIsShownWhatCanBeSeen"),
    at_length("override-mark-in-a-name", PROTOCOL + "label.cpp",
              "within(0x202a, 0x202e)", "within(0x202a, 0x202d)",
              "a name may contain the mark that reverses the text after it",
              "Label.RefusesControlCharactersLineBreaksAndDirectionMarks"),
    at_length("name-of-any-capitals", MATCH + "player_names.cpp",
              "taken_.insert(lookAlikeKey(name)).second", "taken_.insert(name).second",
              "names that differ only in capitals are not told apart",
              "PlayerNamesTest.NamesThatLookAlikeGetANumber"),
]
