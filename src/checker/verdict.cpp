#include "verdict.hpp"

#include "text.hpp"

namespace mdm::checker {
namespace {

/// The parts of the question, in the order of section 7.
class Parts {
public:
  /// Adds a part: `#` stands for the next number, `@` for the unit. Without numbers there is none.
  void add(std::string_view words, const Numbers &numbers, const std::string &unit = {}) {
    if (numbers.empty())
      return;
    std::string part;
    auto number = numbers.begin();
    for (const char c : words)
      part += c == '#' ? std::string((number++)->text) : c == '@' ? unit : std::string{c};
    add(part);
  }
  void add(const std::string &part) { text_ += (text_.empty() ? "" : "; ") + part; }
  const std::string &text() const { return text_; }

private:
  std::string text_;
};

void add_tolerances(Parts &parts, const Certificate &c, const std::string &unit) {
  parts.add("retained within #% of the total mass", c.retained);
  parts.add("retained within the file's tolerances", c.retained_file);
  parts.add("passing within #% of the total mass", c.passing);
  parts.add("passing within the file's tolerances", c.passing_file);
  std::string each = "passing within #%";
  for (std::size_t i = 1; i < c.passing_each.size(); ++i)
    each += ", #%";
  parts.add(each + " of the total mass from the finest sieve up", c.passing_each);
  parts.add("total deviation within #% of the total mass", c.total);
  for (std::size_t i = 0; i < c.band.size(); i += 3)
    parts.add("# to #% of the total mass passing # @", {c.band[i + 1], c.band[i + 2], c.band[i]}, unit);
  parts.add("passing within the file's limits", c.band_file);
}

void add_gradation(Parts &parts, const Gradation &gradation) {
  const bool inches = gradation.sizes == "size_in", names = gradation.sizes == "sieve";
  const std::string from = inches ? ", from inches" : names ? ", from sieve names" : "";
  parts.add("sizes in " + (gradation.sizes == "size_phi" ? "phi" : gradation.unit() + from));
  if (gradation.has_factors)
    parts.add("factors from the file");
  if (gradation.implied_pan)
    parts.add("a pan implied below the finest sieve");
  const bool percents = gradation.values == "retained_percent";
  mpq_class sum = 0;
  for (const mpq_class &mass : gradation.masses)
    sum += mass;
  if ((percents && sum != 100) || (gradation.values == "retained_fraction" && sum != 1))
    parts.add((percents ? "percents sum to " : "fractions sum to ") + plain_decimal(sum));
  if (!gradation.limits.empty())
    parts.add("masses from the middle of the file's limits");
}

void add_question(Parts &parts, const Certificate &c, const std::string &unit) {
  parts.add("at least # particles in each class with mass", c.min_per_class);
  parts.add("solids of a cylinder of diameter # @ and height # @ at void ratio #", c.cylinder, unit);
  parts.add("solids of a box of # x # x # @ at void ratio #", c.box, unit);
  parts.add("solids of at least # @^3", c.solids_volume, unit);
  parts.add("openings multiplied by #", c.size_factor);
  parts.add("classes below # @ left out", c.cut_below, unit);
  parts.add("the pan counted as # @", c.pan_size, unit);
}

} // namespace

namespace {

/// What is claimed, with the words that say what is matched.
std::string claim(const Certificate &c, const std::string &matches) {
  const std::string or_more = c.at_least.empty() ? "" : ", " + std::string(c.at_least[0].text) + " or more,";
  const std::string smallest = "the smallest number of particles" + or_more + " that" + matches;
  if (c.bound.empty())
    return "no number of particles" + or_more + matches;
  const std::string bound(c.bound[0].text);
  if (c.particles.empty())
    return "no number of particles below " + bound + or_more + matches;
  const std::string N(c.particles[0].text);
  return bound == N ? "N = " + N + " is " + smallest : smallest + " is between " + bound + " and " + N;
}

} // namespace

std::string accepted_line(const Gradation &gradation, const Certificate &certificate,
                          const std::string &file) {
  const std::string unit = gradation.unit();
  Parts parts;
  add_tolerances(parts, certificate, unit);
  parts.add(certificate.law[0].value.get_den() == 1 ? "mass law x^#" : "mass law x^(#)", certificate.law);
  add_gradation(parts, gradation);
  add_question(parts, certificate, unit);
  const std::string matches =
      " matches " + quoted_name(file) + (certificate.tree.empty() ? " exactly" : " within a tolerance");
  return "accepted: " + claim(certificate, matches) + " (" + parts.text() + ")";
}

std::string refused_line(const std::string &file) {
  return "refused: the certificate does not prove its claim about " + quoted_name(file);
}

} // namespace mdm::checker
