#include "files/answer_stream.hpp"

#include "files/proof_stream.hpp"

#include <fmt/format.h>

namespace mdm {

AnswerStream::AnswerStream(const std::string &path) : stream_(path), index_(proof_index_path(path)) {
  index_.write("mdm-proofs sample 1\n");
}

void AnswerStream::add(std::uint64_t line, std::size_t number, const AnswerProof &proof) {
  stream_.write(proof.sample);
  stream_.write(proof.certificate);
  index_.write(
      fmt::format("{} {} {} {} {}\n", line, number, offset_, proof.sample.size(), proof.certificate.size()));
  offset_ += proof.sample.size() + proof.certificate.size();
}

void AnswerStream::commit() {
  stream_.commit();
  index_.commit();
}

} // namespace mdm
