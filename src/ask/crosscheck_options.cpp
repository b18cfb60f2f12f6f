#include "ask/crosscheck_options.hpp"

#include "ask/option_values.hpp"

namespace mdm {

const std::vector<OptionRow<CrosscheckTexts>> CrosscheckTexts::options = {
    {"size-tolerance", "EPS", OptionKind::number,
     "how far sizes may be off, as a part of the size as stated (1e-9)", &CrosscheckTexts::size_tolerance}};

const std::vector<OptionRow<CrosscheckTexts>> CrosscheckTexts::limit_options = {
    {"max-steps", "N", OptionKind::number,
     "stop the search for a smallest match after so many steps (67108864; undecided, exit 3)",
     &CrosscheckTexts::max_steps},
    {"node-limit", "N", OptionKind::number, "stop after so many nodes of the search for a tolerance (exit 3)",
     &CrosscheckTexts::node_limit}};

Rational CrosscheckTexts::most_size_error() const {
  const std::string text = size_tolerance.value_or("1e-9");
  const Rational r = not_negative("size-tolerance", text);
  if (r >= 1)
    throw InputError(option("size-tolerance") + ": " + in_quotes(text) +
                     " is not below 1: it is a part of the size, such as 1e-9");
  return r;
}

std::string CrosscheckTexts::question_words() const {
  std::string text;
  const auto add = [&text](const std::string &name, const OptionText &value) {
    if (value && name != "max-steps" && name != "node-limit")
      text += (text.empty() ? "" : " ") + option(name) + " " + *value;
  };
  for (const std::string &tolerance : tolerances)
    add("tolerance", tolerance);
  add("band", band);
  for_each_option(*this, add);
  return text;
}

CrosscheckQuestion::CrosscheckQuestion(const CrosscheckTexts &asked, const ReadBand &read_band) {
  if (asked.max_steps)
    limits_.max_steps = natural64("max-steps", *asked.max_steps);
  if (asked.node_limit)
    limits_.node_limit = natural64("node-limit", *asked.node_limit);
  if (!asked.question_words().empty())
    asked_ = asked.question_of_both(read_band);
}

Crosscheck CrosscheckQuestion::problem(const Gradation &g, const ProgressCall &progress) const {
  return asked_ ? Crosscheck(g, asked_->of(g), limits_, progress) : Crosscheck(g, limits_, progress);
}

} // namespace mdm
