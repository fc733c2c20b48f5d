#include "server/admin/console_reply.h"

#include <gtest/gtest.h>

#include <sstream>

namespace platon::console_reply_test {
namespace {

ConsoleReply sent(const ConsoleReply& reply) {
  std::istringstream stream(encode(reply));
  ConsoleReplyReader reader;
  std::optional<ConsoleReply> received;
  for (std::string line; std::getline(stream, line);) {
    EXPECT_FALSE(received) << "a line after the end of the reply: " << line;
    received = reader.add(line);
  }
  return received.value();
}

TEST(ConsoleReply, TheEncodingIsThatOfTheManual) {
  EXPECT_EQ(encode({true, "one\n two"}), " one\n  two\nok\n");
  EXPECT_EQ(encode({false, "no"}), " no\nfailed\n");
  EXPECT_EQ(encode({true, ""}), "ok\n");
}

TEST(ConsoleReply, ArrivesAsItWasSent) {
  for (const ConsoleReply& reply : {ConsoleReply{true, ""},
                                    {false, ""},
                                    {true, "one"},
                                    {false, "one\ntwo\n three"},
                                    {true, "ok\nfailed"},
                                    {true, "a\n\nb"}}) {
    EXPECT_EQ(sent(reply), reply) << reply.text;
  }
}

TEST(ConsoleReply, AReaderReadsOneReplyAfterTheOther) {
  ConsoleReplyReader reader;
  EXPECT_EQ(reader.add(" a"), std::nullopt);
  EXPECT_EQ(reader.add("failed"), (ConsoleReply{false, "a"}));
  EXPECT_EQ(reader.add(" b"), std::nullopt);
  EXPECT_EQ(reader.add("ok"), (ConsoleReply{true, "b"}));
}

TEST(ConsoleReply, WhatATerminalWouldObeyIsNotPrinted) {
  ConsoleReplyReader reader;
  for (const char* line :
       {" \x1b[2J\x1b]0;title\x07", " tab\tbell\a", " \xe2\x80\xaename", " \xff\xc3", " \xc2\x9b\x7f", " µ “Zoë” 日本"})
    EXPECT_EQ(reader.add(line), std::nullopt);
  EXPECT_EQ(reader.add("ok"), (ConsoleReply{true, "?[2J?]0;title?\ntab?bell?\n?name\n??\n??\nµ “Zoë” 日本"}));
}

}  // namespace
}  // namespace platon::console_reply_test
