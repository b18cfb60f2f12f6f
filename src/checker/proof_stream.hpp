#pragma once

#include "program_files.hpp"

namespace mdm::checker {

/// The certificates of a stream, one after the other, as its index has them (section 10).
class ProofStream {
public:
  /// A stream or an index that is not what it should be. What follows cannot be read.
  struct Broken : std::runtime_error {
    using std::runtime_error::runtime_error;
  };

  /// Opens PATH and PATH.index. Throws std::runtime_error where one cannot be read, and Broken.
  explicit ProofStream(const std::string &path);

  /// The line of the suite that the next certificate is of; nothing at the end.
  const std::optional<std::uint64_t> &number() const { return number_; }
  /// The next certificate. There is one. Throws Broken.
  Input take();
  /// Throws Broken if the stream goes on behind what its index names.
  void check_end();
  /// The place in the index that named the next certificate.
  std::string place() const { return index_.name() + ":" + std::to_string(index_.number()); }

private:
  std::string_view stream_piece();
  void read_entry();
  [[noreturn]] void refuse_entry(const std::string &what) const;

  InputBytes stream_;
  InputLines index_;
  std::optional<std::uint64_t> number_;
  std::uint64_t length_ = 0; ///< of the next certificate
  std::uint64_t offset_ = 0; ///< of it in the stream
};

} // namespace mdm::checker
