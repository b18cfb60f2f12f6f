#pragma once
/// \file
/// The notes of several samples.

#include <string>
#include <utility>
#include <vector>

namespace mdm {

/// `a, b: NOTE`: each note once, after the names of the samples that have it, in the order of the first.
std::vector<std::string>
notes_of_samples(const std::vector<std::pair<std::string, std::vector<std::string>>> &samples);

/// The same of what has an `id` and `notes`.
template <class Sample>
std::vector<std::string> notes_of_samples(const std::vector<Sample> &samples) {
  std::vector<std::pair<std::string, std::vector<std::string>>> all;
  for (const Sample &s : samples)
    all.emplace_back(s.id, s.notes);
  return notes_of_samples(all);
}

} // namespace mdm
