#include "cli/solve_texts.hpp"

#include "cli/option_values.hpp"

#include <mdm/text/error.hpp>

namespace mdm::cli {
namespace {

ScaleChoice scale_of(const std::string &text) {
  if (text == "robust")
    return ScaleChoice::robust;
  if (text == "upper")
    return ScaleChoice::upper;
  throw InputError("--scale: " + in_quotes(text) + " is neither robust nor upper");
}

/// The name of the kind without a value.
std::string kind_of(const SolveTexts &others) {
  return others.tolerances.empty() ? "retained" : others.tolerances.front();
}

} // namespace

const std::array<SolveTexts::Named, 16> SolveTexts::all = {{{"--min-per-class", &SolveTexts::min_per_class},
                                                            {"--at-least", &SolveTexts::at_least},
                                                            {"--at-most", &SolveTexts::at_most},
                                                            {"--specimen", &SolveTexts::specimen},
                                                            {"--void-ratio", &SolveTexts::void_ratio},
                                                            {"--solids-volume", &SolveTexts::solids_volume},
                                                            {"--law", &SolveTexts::law},
                                                            {"--size-factor", &SolveTexts::size_factor},
                                                            {"--cut-below", &SolveTexts::cut_below},
                                                            {"--pan-size", &SolveTexts::pan_size},
                                                            {"--digits", &SolveTexts::digits},
                                                            {"--scale", &SolveTexts::scale},
                                                            {"--max-steps", &SolveTexts::max_steps},
                                                            {"--node-limit", &SolveTexts::node_limit},
                                                            {"--time-limit", &SolveTexts::time_limit},
                                                            {"--gap", &SolveTexts::gap}}};

AskedQuestion GradationTexts::question() const {
  AskedQuestion asked;
  if (law)
    asked.rest.law = named("--law", *law, parse_mass_law);
  if (pan_size)
    asked.pan_size = length("--pan-size", *pan_size);
  if (cut_below)
    asked.cut_below = length("--cut-below", *cut_below);
  if (size_factor)
    asked.rest.size_factor = positive("--size-factor", *size_factor);
  return asked;
}

AskedQuestion SolveTexts::question(const ReadBand &read_band) const {
  if (is_tolerant() && scale)
    throw InputError("--scale: sizes within a tolerance are as far from all bounds as can be: leave it out");
  if (is_tolerant() && max_steps)
    throw InputError("--max-steps: it is of exact matches: give --node-limit, or --time-limit");
  if (!is_tolerant() && node_limit)
    throw InputError("--node-limit: it is of matches within a tolerance: give --max-steps, or --time-limit");
  if (!is_tolerant() && gap)
    throw InputError("--gap: it is of matches within a tolerance: give --max-steps, or --time-limit");
  return question_of_both(read_band);
}

AskedQuestion SolveTexts::question_of_both(const ReadBand &read_band) const {
  AskedQuestion asked = GradationTexts::question();
  Question &q = asked.rest;
  for (const std::string &text : tolerances)
    q.tolerances.push_back(named("--tolerance", text, parse_tolerance));
  if (band)
    q.band = read_band(*band);
  if (min_per_class)
    q.min_per_class = natural("--min-per-class", *min_per_class, 0);
  if (at_least)
    q.at_least = std::max(natural("--at-least", *at_least, 0), Integer(1));
  if (specimen.has_value() != void_ratio.has_value())
    throw InputError("--specimen and --void-ratio belong together");
  if (specimen && solids_volume)
    throw InputError("--specimen and --solids-volume: give one of them");
  if (void_ratio)
    not_negative("--void-ratio", *void_ratio);
  if (solids_volume)
    q.solids = SolidsVolume{positive("--solids-volume", *solids_volume)};
  if (specimen)
    asked.specimen = AskedSpecimen{*specimen, *void_ratio};
  asked.in(SizeUnit::mm); // refuses a wrong specimen before a file is read
  return asked;
}

SolveOptions SolveTexts::options(bool keep_proof) const {
  SolveOptions o;
  o.limits.keep_proof = keep_proof;
  if (at_most)
    o.at_most = natural("--at-most", *at_most, 0);
  if (digits)
    o.digits = digits_of("--digits", *digits);
  if (scale)
    o.scale = scale_of(*scale);
  if (max_steps)
    o.limits.max_steps = natural64("--max-steps", *max_steps);
  if (node_limit)
    o.limits.node_limit = natural64("--node-limit", *node_limit);
  if (gap)
    o.limits.gap = not_negative("--gap", *gap);
  if (time_limit)
    o.limits.deadline = std::chrono::steady_clock::now() + duration("--time-limit", *time_limit);
  return o;
}

Budget BudgetTexts::budget(const SolveTexts &others) const {
  if (others.tolerances.size() > 1)
    throw InputError("--particles: it chooses one tolerance: give one --tolerance, without a value");
  const std::string kind = kind_of(others);
  if (kind != "retained" && kind != "passing" && kind != "total")
    throw InputError("--tolerance: " + in_quotes(kind) +
                     ": --particles chooses the value: write retained, passing or total");
  if (others.band || others.at_most)
    throw InputError(std::string(others.band ? "--band" : "--at-most") +
                     ": it does not go with --particles: leave it out");
  Budget budget;
  budget.particles = natural("--particles", *particles, 1);
  budget.kind = parse_tolerance(kind + ":0%").kind;
  if (grid)
    budget.grid = positive("--grid", *grid);
  return budget;
}

AskedQuestion BudgetTexts::question(const SolveTexts &others, const ReadBand &read_band) const {
  budget(others); // which refuses other tolerances
  SolveTexts with_value = others;
  with_value.tolerances = {kind_of(others) + ":0%"};
  AskedQuestion asked = with_value.question(read_band);
  asked.rest.tolerances.clear();
  return asked;
}

} // namespace mdm::cli
