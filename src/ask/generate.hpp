#pragma once
/// \file
/// Representative sets from grading curves: what is asked, and the set.

#include "answer/generated.hpp"
#include "ask/beta_options.hpp"
#include "ask/outcome.hpp"
#include "ask/reading_options.hpp"
#include "papers/accessible_shapes.hpp"

#include <functional>
#include <vector>

namespace mdm {

/// What is asked of a set, as texts.
struct GenerateTexts : BetaTexts {
  OptionText curve, between, pan_size;
  OptionText classes, classing, min_per_class, largest_share, at_least, at_most, dimension, method;
  OptionText match_digits, time_limit, seed, points, table, digits;
  bool sizes = false, spread = false, quantiles = false;
  bool accessible = false;
  OptionText a, b;                  ///< shapes of accessible
  OptionText c_u, c_c, fit, within; ///< of the shapes with a C_u and a C_c (ask/inverse.hpp)
  ReadingTexts reading;
  std::string format = "text"; ///< of the report: text, json or csv

  /// All but those of reading: of a set, of accessible alone, of shapes, and of what is told.
  static const std::vector<OptionRow<GenerateTexts>> options, accessible_options, inverse_options,
      answer_options;

  bool is_text() const { return format == "text"; }
  bool is_csv() const { return format == "csv"; }
  bool is_matched() const { return method == "match"; }
  /// The sizes of a spread are what it is asked for.
  bool writes_sizes() const { return sizes || (spread && !is_text()); }
};

/// The content of the file that the curve is in.
using ReadCurve = std::function<std::string(const std::string &path)>;

/// Refuses options that do not go together. \throws InputError naming them
void check_generate(const GenerateTexts &asked);
/// How the sizes that are written are drawn.
Draws draws_of(const GenerateTexts &asked);
/// The set. A time limit counts from this call. \throws InputError naming the option or the file
GeneratedSet generated(const GenerateTexts &asked, const ReadCurve &read);
/// Refuses to list more sizes than a file can hold.
void check_listed(const GeneratedSet &set, const Integer &particles);
Outcome outcome_of(const GeneratedSet &set);

/// Which shapes take few particles, instead of a set. \throws InputError naming the option
AccessibleQuestion accessible_question(const GenerateTexts &asked);
/// The rows of its grid, which are still to be filled.
std::vector<AccessibleRow> accessible_grid(const AccessibleQuestion &question);

} // namespace mdm
