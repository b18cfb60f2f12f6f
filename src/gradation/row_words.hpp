#pragma once
/// \file
/// The words that laboratories put beside masses: in rows of a table that are no sieves, above and below it.

#include <string>
#include <string_view>

namespace mdm {

/// What a number beside such words is.
enum class RowMeaning {
  none,                  ///< the words are not known, or mean more than one thing
  pan,                   ///< what fell into the pan
  wash_loss,             ///< what was washed out before sieving
  pan_and_wash,          ///< both
  passing,               ///< what passes the sieve that is named, in whichever way
  total,                 ///< of the rows
  initial_mass,          ///< dry, before washing
  sieved_mass,           ///< dry, before sieving: of a washed sample without what was washed out
  washed_mass,           ///< dry, after washing
  sieve_loss,            ///< what was lost in sieving
  container,             ///< empty
  with_container,        ///< the dry sample in its container
  washed_with_container, ///< the same, after washing
  moist_mass
};

/// Such words with the sieve that they name, if they do: `Passing No. 200`, `Pan (< 0.063 mm)`.
struct RowWords {
  RowMeaning meaning = RowMeaning::none;
  std::string sieve = {};
};

/// The meaning of a label in English, German, French, Spanish or Italian all of whose words are known.
RowWords row_words(std::string_view label);

/// True where a word with the stem of washing is in the text.
bool speaks_of_washing(std::string_view text);

/// True where a word of a part that was sieved for the whole is in the text: split, subsample, riffled,
/// reduced.
bool speaks_of_splitting(std::string_view text);

/// True for the label of a row that says that it has two parts: `Pan + wash`; `Pan (wash)` may be one.
bool joins_parts(std::string_view label);

/// True for words of what passes a sieve, whose percents may be of that part: fraction, fines, < 63 um.
bool speaks_of_part(std::string_view text);

/// True where a sample is named: sample, specimen, probe.
bool speaks_of_sample(std::string_view text);

/// True for the header of a column that says whose a row is: Sample, Borehole, Depth (m).
bool names_samples(std::string_view header);

/// True for words that may be those of what passed the finest sieve: rest, fines, filler.
bool may_be_fines(std::string_view text);

/// True for words of what stays on a sieve: retained, oversize.
bool speaks_of_retaining(std::string_view text);

/// True for words of a moist mass, of water, or of a container with what is in it.
bool speaks_of_moisture_or_container(std::string_view text);

/// True for words of what was washed, or stayed: washed sample, wash residue.
bool names_washed_part(std::string_view text);

/// True where the text names a mass: mass, weight, g, kg.
bool speaks_of_mass(std::string_view text);

/// True for a row's words that may be a place or a step of the work as well as the pan or a wash: bottom,
/// wash.
bool may_be_remark(std::string_view label);

} // namespace mdm
