#pragma once

#include <cstdint>
#include <span>
#include <string>

/// Fuzz targets. Each makes an input from any bytes, runs the code under test with it and checks the result. It returns
/// a description of the fault found, or an empty string.
namespace platon::fuzz {

using Bytes = std::span<const std::uint8_t>;

/// A shape, a displacement and a segment: compares `Sweep` with two independent evaluations.
std::string sweepFault(Bytes bytes);
/// Entities among segments, on the plane or on a solid, for some ticks: checks the invariants I1, I2, I5 and I6 in
/// every leg, the order of contacts, and that a world restored from a saved state moves like the first.
std::string sceneFault(Bytes bytes);
/// A level text: it is refused with a diagnostic, or the level is valid.
std::string levelFault(Bytes bytes);
/// A saved game, possibly forged: it is refused without effect, or the game can be continued.
std::string gameStateFault(Bytes bytes);
/// A recording, valid or forged: it is read to its end or refused, and every block read is one that a game can play;
/// the client plays every valid one, and finds the run in it.
std::string recordingFault(Bytes bytes);
/// A network message: it is refused, or equals itself after encoding and decoding. What is shown of the name of a
/// player is taken for this name.
std::string protocolFault(Bytes bytes);
/// Datagrams of newcomers, a server and strangers, any of them changed, repeated or sent in another name: the server
/// keeps nothing and sends no more bytes than came until a cookie is returned, contents arrive unchanged and once, and
/// a newcomer always can join afterwards.
std::string handshakeFault(Bytes bytes);
/// Sealed datagrams in any order, with losses and changes: a model with full sequence numbers agrees about each, and
/// contents are checked as those of ENet.
std::string channelFault(Bytes bytes);
/// What arrives at the console or the metrics of a server: each line is refused with a sentence or is a command with
/// values in their limits; each request has an answer; nothing depends on how the bytes are cut.
std::string consoleFault(Bytes bytes);
/// A configuration file: each error is one printable line, and each option has a value that it accepts.
std::string configFault(Bytes bytes);
/// A ban file: it is refused with errors inside the text, or every ban is found, and the list survives changes.
std::string banListFault(Bytes bytes);
/// A file of best times: it is refused with errors inside the text, or it is written and read again alike, and keeps
/// the lesser of two times.
std::string bestTimesFault(Bytes bytes);
/// A list of servers, as a text or as entries that are signed and perhaps changed: it is refused with a sentence, or
/// exactly the servers that signed their entries are read, each address once, and read again alike when written.
std::string serverListFault(Bytes bytes);

/// A settings file: each error is one printable line, what was read is written and read again alike, each key belongs
/// to one control at most, and the menu can always be reached.
std::string settingsFault(Bytes bytes);

}  // namespace platon::fuzz
