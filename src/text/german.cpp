// What comes in is an English text, what goes out is German. A row's English text is cut at its places into
// pieces. The text must begin with the first piece and end with the last; between two pieces a place takes as
// little as it can, and more where the rest does not match then. A place of a group must be one of its texts,
// by the same rule; {#} is a whole number. What has failed at a place and a position is not tried again. A
// text that takes more steps than any note does stays as it is. src/web/page/german.js does the same.

#include "text/german.hpp"

#include <algorithm>
#include <set>

namespace mdm {
namespace {

constexpr std::size_t most_german_bytes = 2000;
constexpr unsigned deepest_group = 12; ///< groups within groups
constexpr std::size_t most_german_steps = 100'000;

} // namespace

/// One row against one text.
class Translator::RowMatch {
public:
  RowMatch(const Translator &all, const Row &row, std::string_view text, Work &work)
      : all_(all), row_(row), text_(text), work_(work) {}

  std::optional<std::string> german() {
    const std::string_view first = row_.english.pieces.front();
    if (!text_.starts_with(first) || !fill(0, first.size()))
      return std::nullopt;
    std::string result(row_.german.pieces.front());
    for (std::size_t i = 0; i < row_.german.places.size(); ++i) {
      const std::string_view place = row_.german.places[i];
      const bool is_number = !place.empty() && place[0] >= '0' && place[0] <= '9';
      result += contents_[is_number ? static_cast<std::size_t>(place[0] - '0') : i];
      result += row_.german.pieces[i + 1];
    }
    return result;
  }

private:
  /// Fills the places from `place` on with the text from `begin` on.
  bool fill(std::size_t place, std::size_t begin) {
    if (place == row_.english.places.size())
      return begin == text_.size();
    if (failed_.contains({place, begin}))
      return false;
    const std::string_view next = row_.english.pieces[place + 1];
    std::size_t end = begin;
    if (place + 1 == row_.english.places.size()) // only the text's end will do
      end = std::max(begin, text_.size() - std::min(next.size(), text_.size()));
    for (end = text_.find(next, end); end != std::string_view::npos && ++work_.steps <= most_german_steps;
         end = text_.find(next, end + 1))
      if (const std::optional<std::string> content = content_of(place, text_.substr(begin, end - begin))) {
        contents_.push_back(*content);
        if (fill(place + 1, end + next.size()))
          return true;
        contents_.pop_back();
      }
    failed_.insert({place, begin});
    return false;
  }

  std::optional<std::string> content_of(std::size_t place, std::string_view found) const {
    const std::string_view group = row_.english.places[place];
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    if (group.empty() ||
        (group == "#" && !found.empty() && std::all_of(found.begin(), found.end(), is_digit)))
      return std::string(found);
    ++work_.depth;
    std::optional<std::string> german = all_.of_group(group, found, work_);
    --work_.depth;
    return german;
  }

  const Translator &all_;
  const Row &row_;
  std::string_view text_;
  Work &work_;
  std::vector<std::string> contents_;
  std::set<std::pair<std::size_t, std::size_t>> failed_; ///< place and position
};

Translator::Translator(const std::vector<GermanText> &texts) {
  for (const GermanText &text : texts) {
    Row row{text.group, cut(text.english), cut(text.german), 0};
    for (const std::string_view piece : row.english.pieces)
      row.letters += piece.size();
    rows_.push_back(std::move(row));
  }
  std::stable_sort(rows_.begin(), rows_.end(),
                   [](const Row &a, const Row &b) { return a.letters > b.letters; });
}

Translator::CutText Translator::cut(std::string_view text) {
  CutText result;
  for (std::size_t begin = 0;;) {
    const std::size_t open = text.find('{', begin);
    result.pieces.push_back(text.substr(begin, open - begin));
    if (open == std::string_view::npos)
      return result;
    const std::size_t close = text.find('}', open);
    result.places.push_back(text.substr(open + 1, close - open - 1));
    begin = close + 1;
  }
}

/// True for a whole note with something around it: no such row is used within another.
bool Translator::holds_note(const Row &row) {
  const std::vector<std::string_view> &places = row.english.places;
  return std::find(places.begin(), places.end(), "note") != places.end();
}

std::optional<std::string> Translator::of_group(std::string_view group, std::string_view text,
                                                Work &work) const {
  if (work.depth > deepest_group)
    return std::nullopt;
  for (const Row &row : rows_)
    if (row.group == group && (work.depth == 0 || !holds_note(row)))
      if (std::optional<std::string> german = RowMatch(*this, row, text, work).german())
        return german;
  return std::nullopt;
}

std::optional<std::string> Translator::german(std::string_view text) const {
  if (text.size() > most_german_bytes)
    return std::nullopt;
  Work work;
  std::optional<std::string> german = of_group("note", text, work);
  return work.steps > most_german_steps ? std::nullopt : german;
}

std::optional<std::string> in_german(std::string_view text) {
  static const Translator all(german_texts());
  return all.german(text);
}

} // namespace mdm
