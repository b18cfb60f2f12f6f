#include "verdict.hpp"

#include "law.hpp"
#include "print.hpp"
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

/// Each percentage beside its opening. Those that the question leaves are the coarsest of the file.
std::string passing_each(const Numbers &percents, const Gradation &gradation) {
  const std::string unit = gradation.unit();
  auto opening = gradation.openings.end() - static_cast<std::ptrdiff_t>(percents.size()) - 1;
  std::string text = "passing within ";
  for (const Number &percent : percents) {
    const std::string size = opening_text(gradation, *opening++);
    text += (&percent == &percents[0] ? "" : ", ") + std::string(percent.text) + "%" +
            (&percent == &percents[0] ? " of the total mass" : "") + " at " +
            (gradation.sizes == "size_phi" ? "phi " + size : size + " " + unit);
  }
  return text + " of the file";
}

void add_tolerances(Parts &parts, const Certificate &c, const Gradation &gradation) {
  const std::string unit = gradation.unit();
  parts.add("retained within #% of the total mass", c.retained);
  parts.add("retained within the file's tolerances", c.retained_file);
  parts.add("passing within #% of the total mass", c.passing);
  parts.add("passing within the file's tolerances", c.passing_file);
  if (!c.passing_each.empty())
    parts.add(passing_each(c.passing_each, gradation));
  parts.add("total deviation within #% of the total mass", c.total);
  for (std::size_t i = 0; i < c.band.size(); i += 3)
    parts.add("# to #% of the total mass passing # @ of the file", {c.band[i + 1], c.band[i + 2], c.band[i]},
              unit);
  parts.add("passing within the file's limits", c.band_file);
}

/// The names, each of which has several rows.
std::string materials_in_words(const std::vector<std::string> &of_rows) {
  std::string names;
  for (std::size_t row = 0; row < of_rows.size(); ++row)
    if (row == 0 || of_rows[row] != of_rows[row - 1])
      names += (row == 0 ? "" : ", ") + quoted_name(of_rows[row]);
  return "classes of the materials " + names;
}

void add_gradation(Parts &parts, const Gradation &gradation) {
  const bool inches = gradation.sizes == "size_in", names = gradation.sizes == "sieve";
  const std::string from = inches ? ", from inches" : names ? ", from sieve names" : "";
  parts.add("sizes in " + (gradation.sizes == "size_phi" ? "phi" : gradation.unit() + from));
  if (gradation.has_factors)
    parts.add("factors from the file");
  if (!gradation.materials.empty())
    parts.add(materials_in_words(gradation.materials));
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

/// What changes the gradation, in the order in which it is applied, with lengths as the file has them; then
/// what is demanded of the sample.
void add_question(Parts &parts, const Certificate &c, const std::string &unit) {
  parts.add("the pan counted as # @ of the file", c.pan_size, unit);
  parts.add("classes below # @ of the file left out", c.cut_below, unit);
  parts.add("openings of the file multiplied by #", c.size_factor);
  parts.add("at least # particles in each class with mass", c.min_per_class);
  parts.add("solids of a cylinder of diameter # @ and height # @ at void ratio #", c.cylinder, unit);
  parts.add("solids of a box of # x # x # @ at void ratio #", c.box, unit);
  parts.add("solids of at least # @^3", c.solids_volume, unit);
}

std::string or_more(const Certificate &c) {
  return c.at_least.empty() ? "" : ", " + std::string(c.at_least[0].text) + " or more,";
}

std::string how(const Certificate &c) {
  return c.tree.empty() ? " exactly" : " within a tolerance";
}

/// What is claimed, with the words that say what is matched.
std::string claim(const Certificate &c, const std::string &matches) {
  const std::string smallest = "the smallest number of particles" + or_more(c) + " that" + matches;
  if (c.bound.empty())
    return "no number of particles" + or_more(c) + matches;
  const std::string bound(c.bound[0].text);
  if (c.particles.empty())
    return "no number of particles below " + bound + or_more(c) + matches;
  const std::string N(c.particles[0].text);
  return bound == N ? "N = " + N + " is " + smallest : smallest + " is between " + bound + " and " + N;
}

/// The same without numbers of the claim.
std::string kind_of_claim(const Certificate &c) {
  const std::string smallest = "the smallest number of particles" + or_more(c) + " that matches" + how(c);
  if (c.bound.empty())
    return "no number of particles" + or_more(c) + " matches" + how(c);
  if (c.particles.empty())
    return "a lower bound on " + smallest;
  return (c.bound[0].value == c.particles[0].value ? "" : "bounds on ") + smallest;
}

void add_law(Parts &parts, const Certificate &c, const std::string &unit) {
  if (!is_power(c))
    return parts.add("mass law " + law_by_values(c, unit));
  parts.add(c.law[0].value.get_den() == 1 ? "mass law x^#" : "mass law x^(#)", c.law);
}

std::string in_parts(const Gradation &gradation, const Certificate &c) {
  Parts parts;
  add_tolerances(parts, c, gradation);
  add_law(parts, c, gradation.unit());
  add_gradation(parts, gradation);
  add_question(parts, c, gradation.unit());
  return " (" + parts.text() + ")";
}

std::string percents(const Percents &p) {
  const std::string lo(p.lo.text), hi(p.hi.text);
  return (lo == hi ? lo : lo + " to " + hi) + " %";
}

std::string how(const SampleCertificate &c) {
  return c.is_tolerant ? " within a tolerance" : " exactly";
}

/// Why a sample does not match.
std::string reason(const SampleCertificate &c) {
  const SampleVerdict &v = c.verdict;
  if (v.kind == SampleVerdict::outside) {
    mpz_class outside = 0;
    for (const Numbers *side : {&c.below, &c.above})
      outside += side->empty() ? mpz_class(0) : mpz_class((*side)[0].value);
    return outside.get_str() + " outside all classes";
  }
  const std::string found = percents(v.found), j = std::to_string(v.index);
  const std::string what = v.kind == SampleVerdict::of_class ? "class " + j + " holds " + found
                           : v.kind == SampleVerdict::passing
                               ? found + " pass the upper opening of class " + j
                               : "all errors together are " + found;
  return what + ", and at " + (v.is_least ? "least " : "most ") + std::string(v.asked.text) +
         " % are asked for";
}

std::string largest_errors(const SampleCertificate &c) {
  std::string text = "; the largest error of a share is " + percents(c.retained.percents) + ", in class " +
                     std::to_string(c.retained.index);
  if (c.passing)
    text += "; of what passes " + percents(c.passing->percents) + ", at the upper opening of class " +
            std::to_string(c.passing->index);
  return text + "; all together " + percents(c.total);
}

} // namespace

std::string accepted_line(const Gradation &gradation, const Certificate &certificate,
                          const std::string &file) {
  return "accepted: " + claim(certificate, " matches " + quoted_name(file) + how(certificate)) +
         in_parts(gradation, certificate);
}

std::string question_in_words(const Gradation &gradation, const Certificate &certificate) {
  Parts parts;
  add_tolerances(parts, certificate, gradation);
  add_law(parts, certificate, gradation.unit());
  add_question(parts, certificate, gradation.unit());
  return kind_of_claim(certificate) + " (" + parts.text() + ")";
}

std::string accepted_sample_line(const Gradation &gradation, const SampleCertificate &c,
                                 const std::string &file, const std::string &sample) {
  const std::string n(c.particles[0].text);
  const bool is_one = n == "1", matches = c.verdict.kind == SampleVerdict::match;
  std::string line =
      "accepted: the " + n + (is_one ? " particle of " : " particles of ") + quoted_name(sample);
  line += matches ? (is_one ? " matches " : " match ") : (is_one ? " does not match " : " do not match ");
  line += quoted_name(file) + how(c);
  if (!matches)
    line += ": " + reason(c);
  if (!matches || c.is_tolerant)
    line += largest_errors(c);
  line += "; conditions ";
  for (std::size_t i = 0; i < c.conditions.size(); ++i)
    line += (i > 0 ? ", " : "") + std::to_string(i + 1) + " " + std::string(c.conditions[i]);
  return line + in_parts(gradation, c.question);
}

std::string question_in_words(const Gradation &gradation, const SampleCertificate &c) {
  Parts parts;
  add_tolerances(parts, c.question, gradation);
  add_law(parts, c.question, gradation.unit());
  add_question(parts, c.question, gradation.unit());
  return "whether the particles match" + how(c) + " (" + parts.text() + ")";
}

std::string refused_sample_line(const std::string &file, const std::string &sample) {
  return "refused: the certificate does not prove its claim about " + quoted_name(sample) + " and " +
         quoted_name(file);
}

std::string refused_line(const std::string &file) {
  return "refused: the certificate does not prove its claim about " + quoted_name(file);
}

} // namespace mdm::checker
