#pragma once
/// \file
/// The gradations of a batch, from suites and from gradation files.

#include "cli/files.hpp"
#include "cli/reading_flags.hpp"

#include <mdm/gradation/read_gradation.hpp>

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace mdm::cli {

/// A gradation of a batch, which is still to be read.
struct BatchItem {
  std::uint64_t number;            ///< from 1 on over all sources; a blank line counts
  std::string where;               ///< names it in messages
  std::function<std::string()> id; ///< of what cannot be read
  std::function<Gradation()> read; ///< empty for a blank line; throws InputError
  /// The file that mdm-check reads as this gradation; empty for a line of the only suite, which
  /// it reads there.
  std::function<std::string(const Gradation &)> checked_as;
};

/// The gradations of files, in order, `-` for standard input. By its content a file is JSON Lines, or a
/// gradation file with one gradation or many. Without files, standard input is JSON Lines.
class BatchSources {
public:
  /// \param flags  of gradation files: JSON Lines, which say what they hold, are refused with them
  BatchSources(std::vector<std::string> files, ReadingFlags flags);

  /// The gradations that are there, at least one and at most `most`; empty at the end. Of a suite it waits
  /// only for the first. Memory: that of the lines, or some 64 MiB of gradation files.
  /// \throws InputError if a file cannot be opened
  std::vector<BatchItem> next(std::size_t most);

private:
  void open(const std::string &file);
  void add_gradations(const std::string &file, FileLines &content);
  void add_lines(std::vector<BatchItem> &items, std::size_t most);

  std::vector<std::string> files_;
  ReadingFlags flags_;
  Reading reading_;
  bool is_stream_;         ///< there were no files
  std::size_t opened_ = 0; ///< of the files
  std::uint64_t count_ = 0;
  std::unique_ptr<FileLines> suite_; ///< that is being read, files_[opened_ - 1]
  std::uint64_t line_ = 0;           ///< of the suite
  std::deque<BatchItem> waiting_;
  std::size_t waiting_bytes_ = 0;
};

} // namespace mdm::cli
