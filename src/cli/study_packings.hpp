#pragma once
/// \file
/// The deposits of the study of Voivret, Delenne and Radjai.

#include "cli/study_files.hpp"
#include "papers/packing_study.hpp"

namespace mdm::cli {

/// The deposits that are made.
struct PackingStudyOptions {
  PackingTerms terms;
  std::uint64_t seeds = 4;
  std::vector<Rational> spans;
  unsigned threads = 1;
  bool quiet = false;
};

/// Makes the deposits, but for those that the journal in the folder has from an earlier run, and adds them
/// to it as they come. \throws InputError if the journal is one of other terms
PackingStudy packing_study(const PackingStudyOptions &options, const std::string &folder);

/// Figures 2, 9, 10 and 11 as tables and, where there are pictures, drawn.
std::vector<StudyFile> packing_files(const PackingStudy &study, const std::optional<StudyPictures> &pictures);

} // namespace mdm::cli
