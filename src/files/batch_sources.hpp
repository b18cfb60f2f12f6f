#pragma once
/// \file
/// The gradations of a batch, from suites and from gradation files.

#include "answer/shard.hpp"
#include "answer/totals.hpp"
#include "files/file_lines.hpp"
#include "files/line_hash.hpp"

#include <mdm/gradation/read_gradation.hpp>

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace mdm {

/// A gradation of a batch, which is still to be read.
struct BatchItem {
  std::uint64_t number;            ///< from 1 on over all sources; a blank line counts, but is no item
  std::string where;               ///< names it in messages
  std::function<std::string()> id; ///< of what cannot be read
  std::function<Gradation()> read; ///< throws InputError
  /// The file that mdm-check reads as this gradation; empty for a line of the only suite, which
  /// it reads there.
  std::function<std::string(const Gradation &)> checked_as;
};

/// The gradations of files, in order, `-` for standard input. By its content a file is JSON Lines, or a
/// gradation file with one gradation or many. Without files, standard input is JSON Lines.
class BatchSources {
public:
  /// \param reading  of gradation files
  /// \param asked  the option of reading that is given, with which JSON Lines, which say what they hold, are refused;
  /// empty: none
  /// \param only_suites gradation files are refused
  BatchSources(std::vector<std::string> files, Reading reading, std::string asked, bool only_suites = false);
  /// The lines of a shard of one suite, or of standard input.
  /// \param alone there are no other lines; they have the numbers that they have in a whole suite without
  /// blank lines
  BatchSources(std::vector<std::string> files, Reading reading, std::string asked, Shard shard, bool alone);

  /// The gradations that are there, at least one and at most `most`; empty at the end. Of a suite it waits
  /// only for the first. Memory: that of the lines, or some 64 MiB of gradation files.
  /// \throws InputError if a file cannot be opened
  std::vector<BatchItem> next(std::size_t most);

  /// What the lines of a shard that is alone say before them that they are of; nothing where they do not.
  /// \throws InputError if the file cannot be opened, or they are of another shard
  std::optional<MadeSuite> made();

  /// What the totals of a shard say of its lines, and of the whole suite where it was read.
  /// \pre next() was empty
  void tell_lines(Totals &totals) const;

private:
  void open(const std::string &file);
  void add_gradations(const std::string &file, FileLines &content);
  void add_materials(const std::string &file, std::shared_ptr<const std::string> text);
  void add_lines(std::vector<BatchItem> &items, std::size_t most);
  bool is_ours(const FileLines::Line &line);
  void take_made(const std::string &line);
  void count_line(const FileLines::Line &line);
  void end_suite();

  std::vector<std::string> files_;
  Reading reading_;
  std::string asked_;
  bool only_suites_;
  bool is_stream_;         ///< there were no files
  std::size_t opened_ = 0; ///< of the files
  std::uint64_t count_ = 0;
  std::unique_ptr<FileLines> suite_; ///< that is being read, files_[opened_ - 1]
  std::uint64_t line_ = 0;           ///< of the suite
  std::uint64_t filled_lines_ = 0;   ///< of them that hold something
  std::optional<Shard> shard_;
  bool is_alone_ = false;                 ///< the shard
  std::optional<MadeShard> made_shard_;   ///< what the first line of a shard that is alone said
  std::optional<LineHash> hash_;          ///< with a shard
  LineSum sum_;                           ///< of the lines of the shard
  LineSum suite_sum_;                     ///< of all lines
  std::optional<FileTotals> file_totals_; ///< with a shard, at the end of its file
  std::deque<BatchItem> waiting_;
  std::size_t waiting_bytes_ = 0;
};

} // namespace mdm
