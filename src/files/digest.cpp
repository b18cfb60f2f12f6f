#include "files/digest.hpp"

#include <openssl/evp.h>

#include <stdexcept>

namespace mdm {
namespace {

void check_crypto(int is_done) {
  if (is_done != 1)
    throw std::runtime_error("libcrypto has no SHA-256");
}

} // namespace

struct Digest::State {
  std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX *)> context{EVP_MD_CTX_new(), EVP_MD_CTX_free};
};

Digest::Digest() : state_(std::make_unique<State>()) {
  check_crypto(EVP_DigestInit_ex(state_->context.get(), EVP_sha256(), nullptr));
}
Digest::~Digest() = default;
Digest::Digest(Digest &&) noexcept = default;

void Digest::add(std::string_view bytes) {
  check_crypto(EVP_DigestUpdate(state_->context.get(), bytes.data(), bytes.size()));
  bytes_ += bytes.size();
}

std::array<unsigned char, 32> Digest::take() {
  const std::array<unsigned char, 32> taken = hash();
  check_crypto(EVP_DigestInit_ex(state_->context.get(), nullptr, nullptr));
  bytes_ = 0;
  return taken;
}

std::array<unsigned char, 32> Digest::hash() {
  std::array<unsigned char, 32> hash{};
  check_crypto(EVP_DigestFinal_ex(state_->context.get(), hash.data(), nullptr));
  return hash;
}

} // namespace mdm
