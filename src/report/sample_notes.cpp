#include "report/sample_notes.hpp"

#include <algorithm>

namespace mdm {

std::vector<std::string>
notes_of_samples(const std::vector<std::pair<std::string, std::vector<std::string>>> &samples) {
  std::vector<std::pair<std::string, std::string>> notes; // the note, and the names of its samples
  for (const auto &[id, own] : samples)
    for (const std::string &note : own) {
      const auto found = std::find_if(notes.begin(), notes.end(),
                                      [&note = note](const auto &known) { return known.first == note; });
      if (found == notes.end())
        notes.emplace_back(note, id);
      else
        found->second += ", " + id;
    }
  std::vector<std::string> lines;
  for (const auto &[note, ids] : notes)
    lines.push_back(ids + ": " + note);
  return lines;
}

} // namespace mdm
