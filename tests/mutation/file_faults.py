"""Faults in how the files of users and operators are opened and read."""

from fault import Fault, at_length

FILES = "protocol/files/"

FILE_FAULTS = [
    at_length("silent-disk-is-waited-for", FILES + "file_writer.cpp", "return now < answerBy_ ? \"\" : kSilence;", "return {};",
              "nobody learns that the disk does not answer",
              "FileWriterTest.ADiskThatDoesNotAnswerIsAFailure"),
    Fault("device-taken-for-a-file", FILES + "regular_file.cpp",
          "  if (std::string fault = faultOfKind(file); !fault.empty()) return {Descriptor(), std::move(fault)};\n", "",
          "a link to /dev/zero is read as if it were a file",
          "RegularFileTest.ALinkToADeviceIsRefused"),
    at_length("pipe-replaced", FILES + "text_file.cpp",
              "  if (std::string fault = faultOfKind(target); !fault.empty()) return fault;\n", "",
              "a file takes the place of a pipe or of a device",
              "TextFileTest.WhatIsNoRegularFileIsNeitherReadNorReplaced"),
    at_length("secret-without-limit", "protocol/transport/secret_file.cpp",
              "text.size() > kMaxSecretBytes", "text.empty()",
              "a file of any size is taken for one with a password",
              "SecretFile.WhatIsNoRegularFileOrTooLargeIsRefused"),
    Fault("planted-link-followed", FILES + "private_file.cpp", "O_CREAT | O_NOFOLLOW", "O_CREAT",
          "a link that somebody has planted leads to a file that the program then makes",
          "PrivateFileTest.ALinkIsNotFollowed"),
    at_length("rights-of-a-strange-file", FILES + "private_file.cpp",
              "status.st_uid == geteuid() && status.st_nlink == 1", "status.st_uid == geteuid()",
              "a second name for a file takes it from those who may read it",
              "PrivateFileTest.AFileWithASecondNameKeepsItsRights"),
    at_length("private-file-stays-public", FILES + "private_file.cpp",
              "(status.st_mode & kOthers) == 0", "(status.st_mode & kOthers) != 0",
              "a file that others may read stays so",
              "PrivateFileTest.AnOlderFileIsTakenFromOthersAndKeepsItsContent"),
    at_length("key-of-many-parts", "server/app/config_file.cpp",
              "if (parts_ > kMaxParts)", "if (parts_ > kMaxParts + 1)",
              "a key may have one part more than is said",
              "ConfigFileTest.AKeyOfTooManyPartsIsRefused"),
    at_length("parts-hidden-behind-quotes", "server/app/config_file.cpp",
              "more < 2 && at_ < text_.size()", "more < 1 && at_ < text_.size()",
              "a string that ends with quotes hides the parts of the keys behind it",
              "ConfigFileTest.PartsAreCountedBehindEveryKindOfString"),
]  # fmt: skip
