#include "law.hpp"

#include "verify.hpp"

#include <algorithm>

namespace mdm::checker {
namespace {

/// On the line from the node before x, at first (0, 0), to the first one that is not below it.
mpq_class value_in_table(const Numbers &nodes, const mpq_class &x) {
  mpq_class size = 0, mass = 0;
  for (std::size_t i = 0; i < nodes.size(); i += 2) {
    const mpq_class &next_size = nodes[i].value, &next_mass = nodes[i + 1].value;
    if (x <= next_size)
      return mass + (x - size) * (next_mass - mass) / (next_size - size);
    size = next_size;
    mass = next_mass;
  }
  throw Refused("law: the table reaches every size");
}

} // namespace

bool is_power(const Certificate &certificate) {
  return certificate.nodes.empty() && certificate.terms.empty();
}

mpq_class value_of_law(const Certificate &certificate, const mpq_class &x) {
  if (certificate.terms.empty())
    return value_in_table(certificate.nodes, x);
  mpq_class value = 0;
  for (std::size_t i = 0; i < certificate.terms.size(); i += 2)
    value += certificate.terms[i].value * raised(x, certificate.terms[i + 1].value.get_num().get_ui());
  return value;
}

Rationals measured_openings(const Gradation &gradation, const Certificate &certificate) {
  if (is_power(certificate))
    return gradation.openings;
  demand(gradation.root == 1, "law: rational openings under a table or sum");
  Rationals values;
  for (const mpq_class &x : gradation.openings)
    values.push_back(value_of_law(certificate, x));
  return values;
}

std::string law_by_values(const Certificate &certificate, const std::string &unit) {
  const Numbers &nodes = certificate.nodes, &terms = certificate.terms;
  std::string text;
  for (std::size_t i = 0; i < nodes.size(); i += 2)
    text += (i == 0 ? "by the table " : ", ") + std::string(nodes[i].text) + " " + unit + ": " +
            std::string(nodes[i + 1].text);
  for (std::size_t i = 0; i < terms.size(); i += 2)
    text += (i == 0 ? "" : " + ") + std::string(terms[i].text) + "*x^" + std::string(terms[i + 1].text);
  return terms.empty() ? text : text + ", x in " + unit;
}

} // namespace mdm::checker
