#pragma once
/// \file
/// Notes and refusals in German.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mdm {

/// A row of german.json. A place is {}, whose content is copied, {#}, which is a number, or {GROUP},
/// which is one of that group's texts. In `german` the places have the same order, or numbers from 0 on.
struct GermanText {
  std::string_view group; ///< `note` of whole texts, else of parts of them
  std::string_view english, german;
};

/// All rows of german.json, in their order.
const std::vector<GermanText> &german_texts();

/// What puts texts into German by rows.
class Translator {
public:
  explicit Translator(const std::vector<GermanText> &texts);

  /// A whole text in German. Nothing for one that no row of the group `note` matches from its beginning to
  /// its end, or one matches in two ways with two outcomes, and for one of more than 2000 bytes. Of several
  /// rows the one with the most text of its own has its way, of equals the first.
  std::optional<std::string> german(std::string_view text) const;

private:
  /// A text cut at its places.
  struct CutText {
    std::vector<std::string_view> pieces; ///< one more than places
    std::vector<std::string_view> places; ///< what is between the braces
  };
  struct Row {
    std::string_view group;
    CutText english, german;
    std::size_t letters; ///< of the English pieces
  };
  /// What was done for a text so far.
  struct Work {
    std::size_t steps = 0;
    unsigned depth = 0; ///< of groups within groups

    bool goes_on(); ///< counts a step; false where there were too many
  };
  class RowMatch;

  static CutText cut(std::string_view text);
  static bool holds_note(const Row &row);
  static bool may_match(const Row &row, std::string_view text);
  std::optional<std::string> of_group(std::string_view group, std::string_view text, Work &work) const;

  std::vector<Row> rows_; ///< those with the most letters first
};

/// The same by german.json.
std::optional<std::string> in_german(std::string_view text);

} // namespace mdm
