"""Faults in how the files of users and operators are opened."""

from fault import Fault, at_length

FILES = "protocol/files/"

FILE_FAULTS = [
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
]  # fmt: skip
