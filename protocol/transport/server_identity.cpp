#include "protocol/transport/server_identity.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <new>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include <sodium.h>

#include "protocol/files/text_file.h"
#include "protocol/program_error.h"

namespace platon {
namespace {

constexpr std::string_view kSecretPrefix = "platon-server-key ";
constexpr int kVariant = sodium_base64_VARIANT_URLSAFE_NO_PADDING;

using SigningKey = std::array<std::uint8_t, crypto_sign_SECRETKEYBYTES>;

template <std::size_t kSize>
std::string base64Of(const std::array<std::uint8_t, kSize>& bytes) {
  std::string text(sodium_base64_encoded_len(kSize, kVariant), '\0');
  sodium_bin2base64(text.data(), text.size(), bytes.data(), kSize, kVariant);
  text.pop_back();  // the terminating zero
  return text;
}

template <std::size_t kSize>
std::optional<std::array<std::uint8_t, kSize>> bytesOf(std::string_view base64) {
  std::array<std::uint8_t, kSize> bytes;
  std::size_t size = 0;
  const char* end = nullptr;
  const int result =
      sodium_base642bin(bytes.data(), kSize, base64.data(), base64.size(), nullptr, &size, &end, kVariant);
  if (result != 0 || size != kSize || end != base64.data() + base64.size()) return std::nullopt;
  return bytes;
}

const std::uint8_t* bytesOfText(std::string_view text) { return reinterpret_cast<const std::uint8_t*>(text.data()); }

}  // namespace

ServerIdentity::ServerIdentity(const CryptoKey& secret) : secret_(secret) {
  SigningKey signing;
  crypto_sign_seed_keypair(publicKey_.data(), signing.data(), secret.data());
  CryptoKey exchange;
  crypto_sign_ed25519_sk_to_curve25519(exchange.data(), signing.data());
  exchange_ = KeyPair::of(exchange);
  sodium_memzero(signing.data(), signing.size());
  wipe(exchange);
}

ServerIdentity ServerIdentity::random() {
  CryptoKey secret;
  randombytes_buf(secret.data(), secret.size());
  ServerIdentity identity(secret);
  wipe(secret);
  return identity;
}

std::optional<ServerIdentity> ServerIdentity::parse(std::string_view text) {
  if (!text.starts_with(kSecretPrefix)) return std::nullopt;
  const std::optional<CryptoKey> secret = keyOf(text.substr(kSecretPrefix.size()));
  return secret ? std::optional(ServerIdentity(*secret)) : std::nullopt;
}

std::string ServerIdentity::text() const { return std::string(kSecretPrefix) + textOf(secret_); }

Signature ServerIdentity::sign(std::string_view message) const {
  SigningKey signing;
  CryptoKey publicKey;
  crypto_sign_seed_keypair(publicKey.data(), signing.data(), secret_.data());
  Signature signature;
  crypto_sign_detached(signature.data(), nullptr, bytesOfText(message), message.size(), signing.data());
  sodium_memzero(signing.data(), signing.size());
  return signature;
}

bool isSignature(const Signature& signature, std::string_view message, const CryptoKey& publicKey) {
  return crypto_sign_verify_detached(signature.data(), bytesOfText(message), message.size(), publicKey.data()) == 0;
}

std::optional<CryptoKey> exchangeKeyOf(const CryptoKey& publicKey) {
  CryptoKey exchange;
  if (crypto_sign_ed25519_pk_to_curve25519(exchange.data(), publicKey.data()) != 0) return std::nullopt;
  return exchange;
}

std::string textOf(const CryptoKey& publicKey) { return base64Of(publicKey); }

std::optional<CryptoKey> keyOf(std::string_view text) { return bytesOf<std::tuple_size_v<CryptoKey>>(text); }

std::string textOf(const Signature& signature) { return base64Of(signature); }

std::optional<Signature> signatureOf(std::string_view text) { return bytesOf<std::tuple_size_v<Signature>>(text); }

CryptoKey presharedKeyOf(std::string_view password, const CryptoKey& serverKey) {
  std::array<std::uint8_t, crypto_pwhash_SALTBYTES> salt;
  crypto_generichash(salt.data(), salt.size(), serverKey.data(), serverKey.size(), nullptr, 0);
  CryptoKey key;
  if (crypto_pwhash(key.data(), key.size(), password.data(), password.size(), salt.data(),
                    crypto_pwhash_OPSLIMIT_INTERACTIVE, crypto_pwhash_MEMLIMIT_INTERACTIVE,
                    crypto_pwhash_ALG_ARGON2ID13) != 0) {
    throw std::bad_alloc();
  }
  return key;
}

Password::Password(std::string text) : shared_(std::make_shared<Shared>()) { shared_->text = std::move(text); }

const CryptoKey& Password::keyFor(const CryptoKey& serverKey) const {
  if (shared_->derivations == 0 || shared_->serverKey != serverKey) {
    shared_->key = presharedKeyOf(shared_->text, serverKey);
    shared_->serverKey = serverKey;
    ++shared_->derivations;
  }
  return shared_->key;
}

namespace {

[[noreturn]] void refuseFile(const std::string& path, const std::string& why) {
  throw ProgramError(ProgramError::kUsage, path + ": error: " + why);
}

[[noreturn]] void refuseToCreate(const std::string& path, int fault) {
  refuseFile(path, std::string("cannot be created: ") + std::strerror(fault) + "; name a file in a writable folder");
}

// Most bytes of a file with a secret.
constexpr std::size_t kMaxSecretBytes = 4096;

std::string firstLine(const std::string& path, Pipes pipes = Pipes::kRefuse) {
  const auto read = readTextFile(path, kMaxSecretBytes, pipes);
  if (const auto* error = std::get_if<ParseError>(&read)) refuseFile(path, error->what + "; name a readable file");
  const auto& text = std::get<std::string>(read);
  if (text.size() > kMaxSecretBytes)
    refuseFile(path, "it has more than " + std::to_string(kMaxSecretBytes) + " bytes; name a file with one line");
  std::string line = text.substr(0, text.find('\n'));
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return line;
}

bool writeAll(int handle, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = write(handle, text.data(), text.size());
    if (count < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return fsync(handle) == 0;
}

[[noreturn]] void refuseToWrite(const std::string& path, int fault) {
  refuseFile(path, std::string("cannot be written: ") + std::strerror(fault) + "; make room on the disk");
}

// Returns an error number of the system; 0 if the text is on the disk. Closes the file.
int writeAndClose(int handle, std::string_view text) {
  const int fault = writeAll(handle, text) ? 0 : errno;
  close(handle);
  return fault;
}

// vfat, exFAT and some network file systems have no links.
bool cannotLink(int fault) { return fault == EPERM || fault == EOPNOTSUPP || fault == ENOSYS; }

// Returns an error number of the system; 0 if the file was made.
int createWithoutLink(const std::string& path, std::string_view text) {
  const int handle = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, S_IRUSR | S_IWUSR);
  if (handle < 0) return errno;
  const int fault = writeAndClose(handle, text);
  if (fault == 0) return 0;
  unlink(path.c_str());
  refuseToWrite(path, fault);
}

// Makes the file with its whole content or not at all: when the disk is full, nothing is left that a later start would
// take for a damaged key. Never replaces a file. Returns an error number of the system; 0 if the file was made.
int create(const std::string& path, const std::string& line) {
  const std::string text = line + "\n";
  std::string part = path + ".XXXXXX";
  const int handle = mkostemp(part.data(), O_CLOEXEC);  // readable only by the owner
  if (handle < 0) return errno;
  const int unwritten = writeAndClose(handle, text);
  int fault = unwritten == 0 && link(part.c_str(), path.c_str()) != 0 ? errno : 0;
  unlink(part.c_str());
  if (unwritten != 0) refuseToWrite(path, unwritten);
  if (cannotLink(fault)) fault = createWithoutLink(path, text);
  if (fault == 0) syncFolder(path);
  return fault;
}

// Nothing if there is no file.
std::optional<ServerIdentity> findIdentity(const std::string& path) {
  if (access(path.c_str(), F_OK) != 0 && errno == ENOENT) return std::nullopt;
  std::optional<ServerIdentity> identity = ServerIdentity::parse(firstLine(path));
  if (!identity) refuseFile(path, "not a key of platon-server; for a new key, name a file that does not exist");
  return identity;
}

}  // namespace

std::string readPasswordFile(const std::string& path) {
  const std::string password = firstLine(path, Pipes::kRead);
  if (password.empty()) refuseFile(path, "the first line is empty; write the password there");
  return password;
}

ServerIdentity readKeyFile(const std::string& path) {
  if (const std::optional<ServerIdentity> found = findIdentity(path)) return *found;
  const ServerIdentity identity = ServerIdentity::random();
  const int fault = create(path, identity.text());
  if (fault == 0) return identity;
  if (const auto found = fault == EEXIST ? findIdentity(path) : std::nullopt) return *found;  // made by another server
  refuseToCreate(path, fault);
}

// A file of another user, such as a secret that is mounted into a container, is shared on purpose.
std::string keyFileWarning(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0 || status.st_uid != geteuid()) return {};
  if ((status.st_mode & (S_IRWXG | S_IRWXO)) == 0) return {};
  return "others may open the file, and anyone who has the key can pose as the server; run chmod 600 " + path;
}

bool checkKeyFile(const std::string& path) {
  if (findIdentity(path)) return true;
  if (access(folderOf(path).c_str(), W_OK | X_OK) != 0) refuseToCreate(path, errno);
  return false;
}

}  // namespace platon
