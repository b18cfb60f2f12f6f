#pragma once
/// \file
/// The files in a zip archive.

#include "text/source.hpp"

#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct zip;

namespace mdm {

/// The most bytes that are unpacked of an archive, all its files together: what is hostile is not unpacked
/// farther.
inline constexpr std::size_t max_unpacked_bytes = std::size_t{64} << 20;

/// A zip archive in memory.
class Archive {
public:
  /// \param bytes must outlive the archive
  /// \throws InputError if it is no sound archive
  Archive(std::string_view bytes, const Source &source);

  /// The content of a file; nothing if there is none of that name.
  /// \throws InputError if it cannot be unpacked, or is more than is left of max_unpacked_bytes
  std::optional<std::string> read(const std::string &name);

private:
  const Source &source_;
  std::unique_ptr<zip, void (*)(zip *)> zip_;
  std::size_t left_ = max_unpacked_bytes;
};

} // namespace mdm
