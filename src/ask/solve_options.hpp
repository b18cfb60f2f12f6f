#pragma once
/// \file
/// The options of solving as texts, and what they ask.

#include "ask/asked_question.hpp"
#include "ask/option_row.hpp"
#include "match/budget.hpp"

#include <mdm/match/solve.hpp>

#include <functional>
#include <string>
#include <vector>

namespace mdm {

/// What stands before the file of a law by table.
inline constexpr std::string_view law_by_table = "table:";

/// Reads that file, of at most max_gradation_bytes and a little more; as it is, unless the program sets
/// another way.
extern std::string (*read_law_file)(const std::string &path);

/// The options that say how a gradation is to be taken. All members throw an InputError that names the option
/// where its value does not serve.
struct GradationTexts {
  OptionText law, size_factor, cut_below, pan_size;

  static const std::vector<OptionRow<GradationTexts>> options;
  AskedQuestion question() const;
};

/// The envelope that --band has.
using ReadBand = std::function<Envelope(const std::string &band)>;

/// True of a kind of tolerance without a value: retained, passing or total.
bool names_kind(std::string_view tolerance);

struct BudgetTexts;

/// All options of solving, likewise.
struct SolveTexts : GradationTexts {
  std::vector<std::string> tolerances;
  OptionText band;
  OptionText min_per_class, at_least, at_most;
  OptionText specimen, void_ratio, solids_volume;
  OptionText digits, scale;
  OptionText max_steps, node_limit, time_limit, gap;

  /// All but those of GradationTexts, by what they are about; search_options are of one search alone.
  static const std::vector<OptionRow<SolveTexts>> tolerance_options, band_options, question_options,
      search_options, answer_options, limit_options;

  /// The source of the gradation: FILE, or else the band alone.
  const std::string &source(const OptionText &file) const { return file ? *file : *band; }
  /// \param reading an option of reading that is given, or an empty text
  /// \throws InputError if there is neither, or if they do not go together
  void check_source(const OptionText &file, const std::string &reading, const std::string &command) const;
  bool is_tolerant() const { return !tolerances.empty() || band; }
  /// An option of these but --band that is given, as messages name it; empty: none.
  std::string given() const;
  AskedQuestion question(const ReadBand &read_band) const;
  /// The same for a command that looks for exact matches and for those within a tolerance: limits of either
  /// serve.
  AskedQuestion question_of_both(const ReadBand &read_band) const;
  /// An option of these, or of a budget, that has no use for a gradation of several materials, as messages
  /// name it; empty: none.
  std::string idle_for_materials(const BudgetTexts &budget) const;
  /// The deadline counts from this call.
  SolveOptions options(bool keep_proof = false) const;
};

/// Calls visit(name, text) for each option of solving but tolerance and band, in one order.
template <class Texts, class Visit>
void for_each_option(Texts &texts, Visit visit) {
  for (const OptionRow<SolveTexts> &row : SolveTexts::question_options)
    visit(row.name, texts.*row.text());
  for (const OptionRow<GradationTexts> &row : GradationTexts::options)
    visit(row.name, texts.*row.text());
  for (const auto *const rows :
       {&SolveTexts::search_options, &SolveTexts::answer_options, &SolveTexts::limit_options})
    for (const OptionRow<SolveTexts> &row : *rows)
      visit(row.name, texts.*row.text());
}

/// A number of particles that chooses the tolerance or the size factor, likewise.
struct BudgetTexts {
  OptionText particles, by, grid;

  static const std::vector<OptionRow<BudgetTexts>> options;

  /// An option of these that is given, as messages name it; empty: none.
  std::string given() const;
  /// Refuses what belongs to a budget where there is none.
  void check() const;
  /// The budget; its kind is the one tolerance of the other options, or retained. \pre particles
  Budget budget(const SolveTexts &others) const;
  /// The question of the other options, without the tolerance or the factor that the budget chooses.
  /// \pre particles
  AskedQuestion question(const SolveTexts &others, const ReadBand &read_band) const;
};

} // namespace mdm
