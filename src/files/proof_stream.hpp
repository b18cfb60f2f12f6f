#pragma once
/// \file
/// The certificates of a suite as one file, with an index beside it.

#include "files/output.hpp"

namespace mdm {

/// The first line of an index (proofs/certificate-format.md, section 10).
inline constexpr const char *proof_index_header = "mdm-proofs 1\n";

/// True of names that end in .proofs or .proofs.zst: they are streams.
bool names_proof_stream(const std::string &path);
/// The index of a stream of proofs.
std::string proof_index_path(const std::string &stream);
/// The line of an index for a certificate.
std::string proof_index_line(std::uint64_t number, std::uint64_t offset, std::uint64_t length);

/// Certificates one after the other, and their index. Both are written beside and take their names in
/// commit().
class ProofStream {
public:
  /// \param keeps_digests see Output::keep_digest
  /// \throws InputError if one of the files cannot be written
  explicit ProofStream(const std::string &path, bool keeps_digests = false);

  /// \param number the gradation's line in the suite; above that of the certificate before
  /// \throws InputError if it cannot be written
  void add(std::uint64_t number, std::string_view certificate);
  /// Adds a certificate that stands in the stream already to the index.
  /// \throws InputError likewise
  void add(std::uint64_t number, std::uint64_t length);
  /// \throws InputError if that fails
  void commit();
  /// The same, when all of it is on the disk.
  void commit_durably();

  /// For their digests.
  Output &stream() { return stream_; }
  Output &index() { return index_; }

private:
  Output stream_, index_;
  std::uint64_t offset_ = 0;
};

} // namespace mdm
