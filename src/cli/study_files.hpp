#pragma once
/// \file
/// What a study writes into its folder.

#include "cli/picture.hpp"

#include <string>
#include <vector>

namespace mdm::cli {

/// A file of the study, complete in memory before any is written.
struct StudyFile {
  std::string name, text;
};

/// Figures of a study, drawn in one format.
class StudyPictures {
public:
  /// \param format svg, png or pdf
  StudyPictures(std::string format, bool quiet) : format_(std::move(format)), quiet_(quiet) {}

  /// The picture as the file `name` with the format's ending.
  StudyFile drawn(const std::string &name, const Figure &figure) const;

private:
  std::string format_;
  bool quiet_;
};

/// Writes all files or none of them. \throws InputError
void write_all(const std::string &folder, const std::vector<StudyFile> &files);

} // namespace mdm::cli
