#pragma once
/// \file
/// The files of shards, as they are joined.

#include "answer/totals.hpp"
#include "files/byte_source.hpp"
#include "text/sink.hpp"

namespace mdm {

/// A file that is copied part by part, and compared with its totals.
class CountedPart {
public:
  /// \throws InputError as ByteSource does
  CountedPart(const std::string &path, const FileTotals &totals);

  /// Hands on a line with its end, in pieces. \throws InputError if there is none
  void line(const Sink &to);
  /// Hands on so many bytes. \throws InputError if there are fewer
  void bytes(std::uint64_t count, const Sink &to);
  bool is_at_end();

  /// \throws InputError if there is more of the file, or it is not what its totals say
  void check_end();
  /// Throws the InputError of a file that is not what its totals say.
  [[noreturn]] void refuse() const;

private:
  bool read();
  void fill();
  void take(std::size_t count, const Sink &to);

  ByteSource bytes_;
  FileTotals totals_;
  std::string buffer_;
  std::size_t taken_ = 0;
};

/// The certificates of a stream by its index, one after the other.
class CountedProofs {
public:
  /// \throws InputError if the stream or its index cannot be read
  CountedProofs(const std::string &stream, const FileTotals &stream_totals, const std::string &index,
                const FileTotals &index_totals);

  /// The line of the suite that the next certificate is of; 0 at the end.
  std::uint64_t number() const { return number_; }
  /// Hands on the next certificate. \return its bytes \throws InputError if it is not there
  std::uint64_t take(const Sink &to);
  /// \throws InputError if a file is not what its totals say
  void check_end();

private:
  std::string next_line();
  void next();

  CountedPart stream_, index_;
  std::uint64_t number_ = 0, length_ = 0;
};

} // namespace mdm
