#pragma once

#include "program_files.hpp"

namespace mdm::checker {

/// A certificate of a stream; of an answer, with its sample.
struct StreamedProof {
  std::optional<Input> sample;
  Input certificate;
};

/// The certificates of a stream, one after the other, as its index has them (section 10).
class ProofStream {
public:
  /// A stream or an index that is not what it should be. What follows cannot be read.
  struct Broken : std::runtime_error {
    using std::runtime_error::runtime_error;
  };

  /// Opens PATH and PATH.index. Throws std::runtime_error where one cannot be read, and Broken.
  explicit ProofStream(const std::string &path);

  /// True if the certificates are of answers: each has a sample, and several may be of one line.
  bool has_samples() const { return has_samples_; }
  /// The line of the suite that the next certificate is of; nothing at the end.
  std::optional<std::uint64_t> number() const {
    return entry_ ? std::optional(entry_->number) : std::nullopt;
  }
  /// The next certificate. There is one. Throws Broken.
  StreamedProof take();
  /// Throws Broken if the stream goes on behind what its index names.
  void check_end();
  /// The place in the index that named the next certificate.
  std::string place() const { return index_.name() + ":" + std::to_string(index_.number()); }

private:
  /// What the index says of a certificate.
  struct Entry {
    std::uint64_t number = 0, answer = 1; ///< the line, and which of its answers
    std::uint64_t sample_length = 0, length = 0;

    std::string name() const;
  };

  std::string_view stream_piece();
  Input take(const std::string &what, std::uint64_t length);
  void read_entry();
  Entry parsed_entry(std::string_view text) const;
  void check_length(const char *what, std::uint64_t length) const;
  [[noreturn]] void refuse_entry(const std::string &what) const;

  InputBytes stream_;
  InputLines index_;
  bool has_samples_ = false;
  std::optional<Entry> entry_; ///< of the next certificate
  std::uint64_t offset_ = 0;   ///< of what comes next in the stream
};

} // namespace mdm::checker
