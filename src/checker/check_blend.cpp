#include "blend.hpp"
#include "verdict.hpp"
#include "verify.hpp"

#include <mdm/checker.hpp>

#include <algorithm>

namespace mdm::checker {
namespace {

using Aim = BlendCertificate::Aim;

std::string listed(const Rationals &numbers) {
  std::string text;
  for (const mpq_class &n : numbers)
    text += (text.empty() ? "" : ", ") + n.get_str();
  return text;
}

const char *standard_of(const ModulusLimits &limits) {
  return limits.standard == ModulusLimits::astm ? "ASTM C125" : "EN 12620";
}

/// What is asked for, in words: all that the files do not say.
std::string question_of(const BlendCertificate &c, const std::vector<JudgedSieve> &sieves,
                        const std::vector<Input> &stockpiles) {
  std::string text = "shares in steps of 1/" + std::to_string(c.steps);
  for (const ShareLimits &s : c.shares)
    text += "; share of " + quoted_name(stockpiles[s.stockpile - 1].name) + " from " + s.least.get_str() +
            " to " + s.most.get_str();
  if (c.at_most)
    text += "; at most " + std::to_string(*c.at_most) + " stockpiles";
  for (const ModulusLimits &m : c.moduli)
    text += std::string("; fineness modulus of ") + standard_of(m) + " from " + m.least.get_str() + " to " +
            m.most.get_str();
  if (c.coarseness)
    text +=
        "; coarseness factor from " + c.coarseness->least.get_str() + " to " + c.coarseness->most.get_str();
  if (c.aim == Aim::cost)
    text += "; costs " + listed(c.of_aim);
  else if (c.aim != Aim::no_aim)
    text += "; targets " + listed(c.of_aim) + " percent";
  text += "; sieves in mm";
  for (const JudgedSieve &s : sieves)
    if (s.kind == JudgedSieve::sieve)
      text += (&s == &sieves.front() ? " " : ", ") + s.size.get_str();
  for (std::size_t i = 0; i < stockpiles.size(); ++i) {
    Rationals at;
    bool is_modulus = false, is_factor = false;
    for (const JudgedSieve &s : sieves) {
      if (std::count(s.interpolated.begin(), s.interpolated.end(), i) == 0)
        continue;
      is_modulus = is_modulus || s.kind == JudgedSieve::modulus;
      is_factor = is_factor || s.kind == JudgedSieve::factor;
      if (s.kind == JudgedSieve::sieve)
        at.push_back(s.size);
    }
    std::string where = listed(at);
    for (const auto &[is_there, words] :
         {std::pair{is_modulus, "sieves of the modulus"}, std::pair{is_factor, "sieves of the factor"}})
      if (is_there)
        where += (where.empty() ? "" : " and at ") + std::string(words);
    if (!where.empty())
      text += "; " + quoted_name(stockpiles[i].name) + " interpolated linear in size at " + where;
  }
  return text;
}

/// What is least, in words.
const char *words_of(Aim aim) {
  return aim == Aim::cost        ? "cost"
         : aim == Aim::deviation ? "sum of deviations from the target"
         : aim == Aim::squares   ? "sum of squared deviations from the target"
                                 : "largest deviation from the target";
}

std::string claim_of(const BlendCertificate &c, const mpq_class &value, const std::vector<Input> &stockpiles,
                     const std::string &limits) {
  std::string names, counts;
  for (std::size_t i = 0; i < stockpiles.size(); ++i) {
    names += (i == 0 ? "" : ", ") + quoted_name(stockpiles[i].name);
    if (c.blend)
      counts += (i == 0 ? "" : ", ") + std::to_string((*c.blend)[i]);
  }
  if (!c.blend)
    return "no blend of " + names + " keeps the limits of " + limits;
  const std::string blend =
      "the blend of " + counts + " steps of " + names + " keeps the limits of " + limits;
  return c.aim == Aim::no_aim
             ? blend
             : blend + ", and none has a lower " + words_of(c.aim) + " than its " + value.get_str();
}

Verdict malformed_blend(const Input &input, const Malformed &error) {
  const auto line = error.at == nullptr || input.is_line
                        ? ""
                        : ":" + std::to_string(1 + std::count(input.text.data(), error.at, '\n'));
  return {Verdict::malformed, {}, {}, printable(input.name) + line + ": " + error.what()};
}

/// The first stockpile whose name another has, too; null: there is none. A verdict could not tell them apart.
const Input *given_twice(const std::vector<Input> &stockpiles) {
  for (auto one = stockpiles.begin(); one != stockpiles.end(); ++one)
    if (std::any_of(one + 1, stockpiles.end(), [one](const Input &other) { return other.name == one->name; }))
      return &*one;
  return nullptr;
}

} // namespace

Verdict check_blend(const Input &specification, const std::vector<Input> &stockpiles,
                    const Input &certificate) {
  if (const Input *const twice = given_twice(stockpiles))
    return {Verdict::malformed,
            {},
            {},
            printable(twice->name) + ": two stockpiles are this file: give each once"};
  const Input *reading = &specification;
  try {
    const Gradation limits = read_gradation(specification.text);
    std::vector<Gradation> gradations;
    for (const Input &stockpile : stockpiles) {
      reading = &stockpile;
      gradations.push_back(read_gradation(stockpile.text));
    }
    reading = &certificate;
    const BlendCertificate c = read_blend_certificate(certificate.text);
    const std::vector<JudgedSieve> sieves = judged_sieves(limits, gradations, c);
    const mpq_class value = verify_blend(sieves, stockpiles.size(), c, certificate.text);
    const std::string question = question_of(c, sieves, stockpiles);
    return {Verdict::accepted,
            "accepted: " + claim_of(c, value, stockpiles, quoted_name(specification.name)) + " (" + question +
                ")",
            question,
            {}};
  } catch (const Refused &reason) {
    return {Verdict::refused,
            refused_line(specification.name),
            {},
            printable(certificate.name) + ": " + reason.what()};
  } catch (const Malformed &error) {
    return malformed_blend(*reading, error);
  }
}

} // namespace mdm::checker
