#pragma once
/// \file
/// Files that are packed.

#include <memory>
#include <string>
#include <string_view>

namespace mdm {

/// Unpacks a text piece by piece, in memory that does not grow with it.
class Unpacker {
public:
  virtual ~Unpacker() = default;
  /// Appends some of the text, at most 128 KiB, and takes what it used off `packed`.
  /// \throws InputError if that is not packed so
  virtual void unpack(std::string_view &packed, std::string &text) = 0;
  /// True if what was unpacked so far is whole.
  virtual bool is_whole() const = 0;
};

/// That of zstd's frames; those that ask for more than 128 MiB are refused.
/// \throws InputError if the program was built without libzstd
std::unique_ptr<Unpacker> zstd_unpacker();
/// That of gzip's members.
/// \throws InputError if the program was built without zlib
std::unique_ptr<Unpacker> gzip_unpacker();

/// True of the first bytes of a file that gzip or zstd packed.
bool is_packed(std::string_view begin);
/// The one that the first bytes of a file tell, or else its name (.zst, .gz); null where nothing is to be
/// unpacked. \throws InputError as these
std::unique_ptr<Unpacker> unpacker_of(std::string_view begin, std::string_view path);

} // namespace mdm
