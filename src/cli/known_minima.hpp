#pragma once
/// \file
/// Least numbers of particles that certificates prove.

#include "files/suite_lines.hpp"

#include <mdm/crosscheck/crosscheck.hpp>
#include <mdm/match/question.hpp>

#include <map>
#include <optional>
#include <string>

namespace mdm::cli {

/// The certificates that `mdm batch SUITE --proofs STREAM` wrote.
class KnownMinima {
public:
  /// \throws InputError if the stream or its index is not what it should be
  explicit KnownMinima(const std::string &stream);

  /// What is proved of the gradation in that line; nothing where it has no certificate. The checker judges
  /// the certificate. Several threads may call it.
  /// \throws InputError if the certificate is refused, or is of another question
  std::optional<KnownMinimum> of(const SuiteLine &line, const Question &question) const;

private:
  std::string certificate(std::uint64_t line) const;

  struct Place {
    std::size_t offset, length;
  };
  std::string path_, stream_;
  std::map<std::uint64_t, Place> places_; ///< by the line of the suite
};

} // namespace mdm::cli
