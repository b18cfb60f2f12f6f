// The SHA-256 of files by Windows.
#include "files/digest.hpp"

#include <windows.h>
// Behind it, which it needs.
#include <bcrypt.h>

#include <algorithm>
#include <stdexcept>

namespace mdm {
namespace {

void check_windows(NTSTATUS status) {
  if (status < 0)
    throw std::runtime_error("Windows has no SHA-256");
}

} // namespace

struct Digest::State {
  BCRYPT_ALG_HANDLE algorithm = nullptr;
  BCRYPT_HASH_HANDLE hash = nullptr;

  State() {
    check_windows(BCryptOpenAlgorithmProvider(&algorithm, BCRYPT_SHA256_ALGORITHM, nullptr, 0));
    begin();
  }
  ~State() {
    BCryptDestroyHash(hash);
    BCryptCloseAlgorithmProvider(algorithm, 0);
  }
  State(const State &) = delete;
  State &operator=(const State &) = delete;

  void begin() { check_windows(BCryptCreateHash(algorithm, &hash, nullptr, 0, nullptr, 0, 0)); }
};

Digest::Digest() : state_(std::make_unique<State>()) {}
Digest::~Digest() = default;
Digest::Digest(Digest &&) noexcept = default;

void Digest::add(std::string_view bytes) {
  bytes_ += bytes.size();
  while (!bytes.empty()) {
    constexpr std::size_t most = std::size_t{1} << 30;
    std::string some(bytes.substr(0, most)); // its bytes are asked for as if they were written
    check_windows(BCryptHashData(state_->hash, reinterpret_cast<PUCHAR>(some.data()),
                                 static_cast<ULONG>(some.size()), 0));
    bytes.remove_prefix(some.size());
  }
}

std::array<unsigned char, 32> Digest::take() {
  const std::array<unsigned char, 32> taken = hash();
  BCryptDestroyHash(state_->hash);
  state_->begin();
  bytes_ = 0;
  return taken;
}

std::array<unsigned char, 32> Digest::hash() {
  std::array<unsigned char, 32> hash{};
  check_windows(BCryptFinishHash(state_->hash, hash.data(), static_cast<ULONG>(hash.size()), 0));
  return hash;
}

} // namespace mdm
