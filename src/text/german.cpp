// What comes in is an English text, what goes out is German. A row's English text is cut at its places into
// pieces: the text must begin with the first, have the others in their order, and end with the last. What is
// between two pieces is a place's. It is copied; but that of a group must be one of its texts, by the same
// rule, and {#} a number. A text that a row matches in two ways with two outcomes stays as it is: one of them
// would change what is to be copied. What has failed at a place and a position is not tried again, and a text
// that takes more steps than any note does stays as it is. src/web/page/german.js does the same.

#include "text/german.hpp"

#include <algorithm>
#include <set>

namespace mdm {
namespace {

constexpr std::size_t most_german_bytes = 2000;
constexpr unsigned deepest_group = 12; ///< groups within groups
constexpr std::size_t most_german_steps = 100'000;

/// Digits, with or without a sign, a point and more digits.
bool is_number(std::string_view text) {
  constexpr std::string_view digits = "0123456789";
  const std::string_view whole = text.substr(text.starts_with('-') ? 1 : 0);
  const std::size_t point = std::min(whole.find_first_not_of(digits), whole.size());
  const std::string_view rest = whole.substr(point);
  return point > 0 && (rest.empty() || (rest.size() > 1 && rest[0] == '.' &&
                                        rest.find_first_not_of(digits, 1) == std::string_view::npos));
}

} // namespace

bool Translator::Work::goes_on() {
  return ++steps <= most_german_steps;
}

/// One row against one text.
class Translator::RowMatch {
public:
  RowMatch(const Translator &all, const Row &row, std::string_view text, Work &work)
      : all_(all), row_(row), text_(text), work_(work) {}

  void run() { fill(0, row_.english.pieces.front().size()); }

  const std::optional<std::string> &german() const { return german_; }
  bool is_ambiguous() const { return is_ambiguous_; }

private:
  /// Fills the places from `place` on with the text from `begin` on, in all ways; false if there is none.
  bool fill(std::size_t place, std::size_t begin) {
    if (place == row_.english.places.size()) {
      if (begin != text_.size())
        return false;
      take();
      return true;
    }
    if (failed_.contains({place, begin}))
      return false;
    const std::string_view next = row_.english.pieces[place + 1];
    std::size_t end = begin;
    if (place + 1 == row_.english.places.size()) // only the text's end will do
      end = std::max(begin, text_.size() - std::min(next.size(), text_.size()));
    bool is_filled = false;
    for (end = text_.find(next, end); end != std::string_view::npos && !is_ambiguous_ && work_.goes_on();
         end = text_.find(next, end + 1))
      if (const std::optional<std::string> content = content_of(place, text_.substr(begin, end - begin))) {
        contents_.push_back(*content);
        is_filled |= fill(place + 1, end + next.size());
        contents_.pop_back();
      }
    if (!is_filled)
      failed_.insert({place, begin});
    return is_filled;
  }

  /// All places are filled.
  void take() {
    std::string german(row_.german.pieces.front());
    for (std::size_t i = 0; i < row_.german.places.size(); ++i) {
      const std::string_view place = row_.german.places[i];
      german += contents_[is_number(place) ? static_cast<std::size_t>(place[0] - '0') : i];
      german += row_.german.pieces[i + 1];
    }
    is_ambiguous_ |= german_ && *german_ != german;
    german_ = std::move(german);
  }

  std::optional<std::string> content_of(std::size_t place, std::string_view found) const {
    const std::string_view group = row_.english.places[place];
    if (group.empty() || (group == "#" && is_number(found)))
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
  std::optional<std::string> german_;
  bool is_ambiguous_ = false;
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

/// False where a text has another beginning or end than a row.
bool Translator::may_match(const Row &row, std::string_view text) {
  return text.size() >= row.letters && text.starts_with(row.english.pieces.front()) &&
         text.ends_with(row.english.pieces.back());
}

std::optional<std::string> Translator::of_group(std::string_view group, std::string_view text,
                                                Work &work) const {
  if (work.depth > deepest_group)
    return std::nullopt;
  for (const Row &row : rows_)
    if (row.group == group && may_match(row, text) && (work.depth == 0 || !holds_note(row))) {
      RowMatch match(*this, row, text, work);
      match.run();
      if (match.german())
        return match.is_ambiguous() ? std::nullopt : match.german();
    }
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
