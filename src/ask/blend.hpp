#pragma once
/// \file
/// The best mix of stockpiles: what is asked, and the blend.

#include "ask/option_row.hpp"
#include "ask/outcome.hpp"
#include "blend/blend_certificate.hpp"
#include "report/blend_report.hpp"

#include <mdm/gradation/read_gradation.hpp>

#include <functional>
#include <vector>

namespace mdm {

/// What is asked of a blend, as texts.
struct BlendTexts {
  OptionText target; ///< its name
  OptionText minimise, step, at_most, all, relax, bailey, node_limit, time_limit;
  std::vector<std::string> costs, shares, limits;

  static const std::vector<OptionRow<BlendTexts>> question_options, answer_options, limit_options;

  /// What is asked for, or what the options that are given have a use for.
  /// \throws InputError naming the option where its value does not serve
  BlendAim aim() const;
  /// How the best blends are searched. A time limit counts from this call.
  /// \throws InputError naming the option where its value does not serve
  BlendOptions search() const;
};

/// Searches for the best blends; where a limit came before all that were asked for, a note of the problem
/// says so.
BlendAnswer find_blends(BlendProblem &problem, const BlendOptions &options);
/// `limited` also there.
Outcome outcome_of(const BlendAnswer &answer, const BlendOptions &options);

/// A blend of stockpiles, or why there is none.
class Blending {
public:
  /// A time limit counts from this call.
  /// \throws InputError naming the option where its value does not serve
  Blending(const BlendTexts &asked, std::vector<Gradation> stockpiles, const Envelope &specification,
           const std::optional<Gradation> &target);

  /// Searches. Cost: exponential in the stockpiles at worst.
  /// \param go_on  asked from time to time; false ends the search
  void search(std::function<bool()> go_on = {});
  void add_note(const std::string &note) { problem_.notes.push_back(note); }

  const BlendProblem &problem() const { return problem_; }
  BlendReport report() const;
  /// What of the best blend passes the sieves of the Bailey method; nothing where it is not asked for, or
  /// there is no blend.
  /// \throws InputError if a stockpile does not tell what passes one of them
  std::optional<BaileyReport> bailey() const;
  Outcome outcome() const { return outcome_of(answer_, options_); }
  /// The gradation of the best blend; nothing where there is none.
  std::optional<Gradation> blended() const;
  /// The same with each stockpile a material of its density, of `NAME=DENSITY,...`.
  /// \throws InputError naming the option where a density is missing
  std::optional<Gradation> blended_with(const std::vector<std::string> &densities) const;
  /// Nothing where the search did not come to its end.
  std::optional<std::string> proof() const;
  /// The same for VIPR checkers.
  /// \throws InputError where that has no form for what is asked
  std::optional<std::string> vipr() const;

private:
  bool has_ended() const {
    return answer_.status == BlendAnswer::Status::optimal || answer_.status == BlendAnswer::Status::none;
  }

  std::vector<Gradation> stockpiles_;
  std::string specification_; ///< its name
  BlendProblem problem_;
  BlendOptions options_;
  std::optional<BaileySieves> bailey_;
  std::optional<NamedMass> mass_; ///< of a blend, where its steps are masses
  BlendAnswer answer_;
};

} // namespace mdm
