#pragma once

#include "unpacker.hpp"

#include <mdm/checker.hpp>

#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// What the program mdm-check reads and writes.
namespace mdm::checker {

constexpr std::size_t most_gradation_bytes = std::size_t{64} << 20U;
constexpr std::size_t most_certificate_bytes = std::size_t{256} << 20U;

/// Throws the message `who: what`.
[[noreturn]] void fail(const std::string &who, const std::string &what);

/// Reads a file, or standard input for `-`, in pieces, so that a device without end ends at the limit. Throws
/// std::runtime_error where it cannot be read.
Input read_input(const std::string &path, std::size_t most_bytes);

/// The reader of standard output has gone.
struct ClosedPipe : std::runtime_error {
  ClosedPipe() : std::runtime_error("standard output is closed") {}
};

/// Writes to standard output. Throws ClosedPipe, or std::runtime_error.
void print(const std::string &text);

/// The bytes of a file, or of standard input for `-`, one piece after the other in memory. What ends in .zst
/// is unpacked.
class InputBytes {
public:
  /// Throws std::runtime_error, as some() does.
  explicit InputBytes(const std::string &path);

  /// What is in memory of what was not taken yet, at least one byte; nothing at the end.
  std::string_view some();
  void take(std::size_t bytes) { piece_.remove_prefix(bytes); }
  const std::string &name() const { return name_; }

private:
  std::string_view read();
  std::string_view unpack();

  std::string name_;
  std::unique_ptr<std::FILE, int (*)(std::FILE *)> file_;
  std::vector<char> memory_;
  std::string_view piece_;
  std::optional<Unpacker> unpacker_; ///< where the name ends in .zst
  std::string_view packed_;
};

/// The lines of a file, or of standard input for `-`, one after the other in memory.
class InputLines {
public:
  /// Throws std::runtime_error, as next() does.
  explicit InputLines(const std::string &path) : bytes_(path) {}

  /// The next line without its end, under the name `file:line`; nothing at the end.
  std::optional<Input> next();
  /// That of the last line.
  std::uint64_t number() const { return number_; }
  /// The last line had an end.
  bool has_line_end() const { return has_line_end_; }
  const std::string &name() const { return bytes_.name(); }

private:
  InputBytes bytes_;
  std::uint64_t number_ = 0;
  bool has_line_end_ = false;
};

} // namespace mdm::checker
