#include "print.hpp"

#include "text.hpp"

#include <algorithm>

namespace mdm::checker {
namespace {

std::string short_text(std::string text) {
  demand_form(std::count_if(text.begin(), text.end(), is_digit) <= 1000, {},
              "a number needs more than 1000 digits without an exponent: choose another unit");
  return text;
}

std::string number(const mpq_class &value) {
  return short_text(plain_decimal(value));
}

/// A text in quotes, those in it doubled.
std::string quoted_field(const std::string &text) {
  std::string field = "\"";
  for (const char c : text)
    field += c == '"' ? "\"\"" : std::string{c};
  return field + "\"";
}

std::string size(const Gradation &gradation, const mpq_class &Y) {
  return short_text(opening_text(gradation, Y));
}

} // namespace

std::string opening_text(const Gradation &gradation, const mpq_class &Y) {
  if (gradation.sizes != "size_phi")
    return plain_decimal(Y);
  if (Y == 0)
    return "pan";
  const auto exponent_of = [](const mpz_class &power_of_2) {
    return static_cast<unsigned long>(mpz_sizeinbase(power_of_2.get_mpz_t(), 2));
  };
  const mpz_class root = gradation.root;
  mpq_class phi(mpz_class(exponent_of(Y.get_den())) - mpz_class(exponent_of(Y.get_num())), root);
  phi.canonicalize();
  return plain_decimal(phi);
}

std::string canonical_csv(const Gradation &gradation) {
  const std::string sizes = gradation.sizes == "size_phi" ? "size_phi" : "size_" + gradation.unit();
  if (!gradation.limits.empty()) {
    std::string text = sizes + ",passing_min_percent,passing_max_percent\n";
    for (const auto &[opening, least, most] : gradation.limits)
      text += size(gradation, opening) + "," + number(least) + "," + number(most) + "\n";
    return text;
  }
  const bool has_tolerances = !gradation.tolerances.empty();
  const bool has_materials = !gradation.materials.empty();
  std::string text = sizes + ",mass" + (has_tolerances ? ",tolerance_percent" : "") +
                     (gradation.has_factors ? ",factor" : "") + (has_materials ? ",material" : "") + "\n";
  for (std::size_t j = 0; j < gradation.openings.size(); ++j)
    text += size(gradation, gradation.openings[j]) + "," + number(gradation.masses[j]) +
            (has_tolerances ? "," + number(gradation.tolerances[j]) : "") +
            (gradation.has_factors ? "," + number(gradation.factors[j]) : "") +
            (has_materials ? "," + quoted_field(gradation.materials[j]) : "") + "\n";
  return text;
}

} // namespace mdm::checker
