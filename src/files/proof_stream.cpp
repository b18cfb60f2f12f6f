#include "files/proof_stream.hpp"

#include <fmt/format.h>

namespace mdm {

bool names_proof_stream(const std::string &path) {
  return path.ends_with(".proofs") || path.ends_with(".proofs.zst");
}

std::string proof_index_path(const std::string &stream) {
  return stream + ".index";
}

std::string proof_index_line(std::uint64_t number, std::uint64_t offset, std::uint64_t length) {
  return fmt::format("{} {} {}\n", number, offset, length);
}

ProofStream::ProofStream(const std::string &path, bool keeps_digests)
    : stream_(path), index_(proof_index_path(path)) {
  if (keeps_digests) {
    stream_.keep_digest();
    index_.keep_digest();
  }
  index_.write(proof_index_header);
}

void ProofStream::add(std::uint64_t number, std::string_view certificate) {
  stream_.write(certificate);
  add(number, certificate.size());
}

void ProofStream::add(std::uint64_t number, std::uint64_t length) {
  index_.write(proof_index_line(number, offset_, length));
  offset_ += length;
}

void ProofStream::commit() {
  stream_.commit();
  index_.commit();
}

void ProofStream::commit_durably() {
  stream_.commit_durably();
  index_.commit_durably();
}

} // namespace mdm
