// A file for Coq that states one answer as a theorem and has Coq's kernel check its evidence
// (proofs/README.md, "A theorem for one answer"). The certificate's own lines are read and written again as
// terms of Certificate.v, so that what Coq checks is what the certificate says. Numbers of more than 20
// digits are hexadecimal, because Coq reads decimals in quadratic time; what it would take minutes for is
// refused with the reason.

#include "proof/coq_file.hpp"

#include "proof/certificate_parts.hpp"
#include "text/option_name.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/proof/certificate.hpp>
#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <iterator>
#include <sstream>

namespace mdm {
namespace {

// ---- Numbers ----

/// Coq reads decimals in quadratic time, 1000 digits in 2 s, and hexadecimals at once.
constexpr std::size_t most_digits = 20;

std::string coq(const Integer &n) {
  const std::string digits = to_string(n);
  return digits.size() <= most_digits ? digits : "0x" + n.str(0, std::ios_base::hex);
}

std::string coq(const Rational &r) {
  const Integer p = numerator(r), q = denominator(r);
  return q == 1 ? coq(p) : fmt::format("({} # {})", coq(p), coq(q));
}

/// An integer of the certificate.
std::string coq_integer(const std::string &word) {
  return word.size() <= most_digits ? word : coq(Integer(word));
}

/// An integer, a decimal or p/q of the certificate.
Rational number(const std::string &word) {
  const std::size_t slash = word.find('/');
  if (slash == std::string::npos && word.find('.') == std::string::npos)
    return Rational(Integer(word));
  if (slash == std::string::npos) {
    std::string digits = word;
    const std::size_t point = digits.find('.');
    digits.erase(point, 1);
    digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));
    return Rational(Integer(digits)) / Rational(power_of_ten(static_cast<unsigned>(word.size() - point - 1)));
  }
  return Rational(Integer(word.substr(0, slash)), Integer(word.substr(slash + 1)));
}

/// A size of the certificate: a decimal where that is short.
std::string coq_size(const std::string &word) {
  return word.size() <= most_digits ? word : coq(number(word));
}

// ---- The certificate ----

using Words = std::vector<std::string>;

/// Its lines, each by its first word.
class Certificate {
public:
  explicit Certificate(const std::string &text) {
    std::istringstream all(text);
    for (std::string line; std::getline(all, line);) {
      std::istringstream words(line);
      lines_.emplace_back(std::istream_iterator<std::string>(words), std::istream_iterator<std::string>());
    }
  }

  const std::vector<Words> &lines() const { return lines_; }

  /// The words behind the name; nothing where there is no such line. The line `name file` is another one.
  std::optional<Words> find(std::string_view name) const {
    for (const Words &line : lines_)
      if (line.front() == name && (line.size() == 1 || line[1] != "file"))
        return Words(line.begin() + 1, line.end());
    return std::nullopt;
  }

  bool says_file(const std::string &name) const {
    return std::find(lines_.begin(), lines_.end(), Words{name, "file"}) != lines_.end();
  }

private:
  std::vector<Words> lines_;
};

std::string optional_number(const Certificate &c, std::string_view name) {
  const std::optional<Words> words = c.find(name);
  return words ? fmt::format("Some {}%Q", coq(number(words->front()))) : "None";
}

std::string integer_or_0(const Certificate &c, std::string_view name) {
  const std::optional<Words> words = c.find(name);
  return words ? coq_integer(words->front()) : "0";
}

// ---- Gradation and question ----

std::string joined(const std::vector<std::string> &parts) {
  return fmt::format("[{}]", fmt::join(parts, "; "));
}

std::string in_lines(const std::vector<std::string> &parts) {
  return fmt::format("[\n  {} ]", fmt::join(parts, ";\n  "));
}

std::string gradation(const Gradation &g) {
  std::vector<std::string> rows;
  for (std::size_t j = 0; j < g.powers().size(); ++j) {
    const Rational tolerance = g.tolerances().empty() ? Rational(0) : g.tolerances()[j];
    rows.push_back(fmt::format("Row {} {} {} {}", coq(g.powers()[j]), coq(g.masses()[j]), coq(g.factor(j)),
                               coq(tolerance)));
  }
  return fmt::format("Gradation {} {} {}", in_lines(rows), g.root(), !g.tolerances().empty());
}

std::string solids(const Certificate &c) {
  if (const std::optional<Words> w = c.find("cylinder"))
    return fmt::format("Cylinder {} {} {}", coq(number((*w)[0])), coq(number((*w)[1])), coq(number((*w)[2])));
  const std::optional<Words> pi = c.find("pi");
  if (!pi)
    return "Anything";
  Rational volume;
  if (const std::optional<Words> w = c.find("box"))
    volume = number((*w)[0]) * number((*w)[1]) * number((*w)[2]) / (1 + number((*w)[3]));
  else
    volume = number(c.find("solids-volume")->front());
  return fmt::format("Volume {} {} {}", coq(volume), coq(number((*pi)[0])), coq(number((*pi)[1])));
}

std::string band(const Match &m) {
  std::vector<std::string> limits;
  if (const std::optional<Envelope> &e = m.question.band) {
    const Rational unit = in_mm(e->unit) / in_mm(m.gradation.unit());
    for (std::size_t i = 0; i < e->sizes.size(); ++i)
      limits.push_back(fmt::format("({}, {}, {})%Q", coq(Rational(e->sizes[i] * unit)),
                                   coq(e->passing_min[i]), coq(e->passing_max[i])));
  }
  return joined(limits);
}

std::string tolerances(const Match &m, const Certificate &c) {
  if (!m.tolerance)
    return "None";
  std::vector<std::string> each;
  for (const std::string &word : c.find("passing-each").value_or(Words{}))
    each.push_back(coq(number(word)) + "%Q");
  return fmt::format(R"(Some {{|
    retained_each := {}; retained_file := {};
    passing_all := {}; passing_file := {};
    passing_each := {};
    Certificate.total := {};
    band := {} |}})",
                     optional_number(c, "retained"), c.says_file("retained"), optional_number(c, "passing"),
                     c.says_file("passing"), joined(each), optional_number(c, "total"), band(m));
}

std::string question(const Match &m, const Certificate &c) {
  return fmt::format(R"({{|
  a := {}; b := {};
  pan_size := {};
  cut_below := {};
  size_factor := {};
  min_per_class := {};
  solids_of := {};
  at_least := {};
  tolerances_of := {} |}})",
                     m.question.law.a, m.question.law.b, optional_number(c, "pan-size"),
                     optional_number(c, "cut-below"), optional_number(c, "size-factor"),
                     integer_or_0(c, "min-per-class"), solids(c), integer_or_0(c, "at-least"),
                     tolerances(m, c));
}

// ---- Evidence ----

/// Class, quantity, mass (of a tolerance) and bounds of the size.
std::string witness(const Certificate &c) {
  std::vector<std::string> classes;
  for (const Words &line : c.lines())
    if (line.front() == "class")
      classes.push_back(fmt::format("Witness {} {} {} {} {}", line[1], coq_integer(line[2]),
                                    line.size() == 6 ? coq(number(line[3])) : "0",
                                    coq_size(line[line.size() - 2]), coq_size(line.back())));
  return in_lines(classes);
}

/// Class j as its range j j; a range i-j of classes as i j.
std::string classes(const std::string &range) {
  const std::size_t dash = range.find('-');
  return dash == std::string::npos ? range + " " + range
                                   : range.substr(0, dash) + " " + range.substr(dash + 1);
}

std::string split(const Words &line) {
  if (line[1] == "M")
    return fmt::format("SplitMass {}", coq(number(line[2])));
  return fmt::format("Split {} {}", classes(line[1]), coq_integer(line[2]));
}

/// A leaf, or one of a window of the mass.
std::string leaf(const Words &line) {
  std::vector<std::string> multiples;
  for (std::size_t i = 1; i + 1 < line.size(); i += 2) {
    const std::string &condition = line[i + 1];
    multiples.push_back(fmt::format("Multiple {} \"{}\" {}", coq_integer(line[i]), condition.front(),
                                    classes(condition.size() == 1 ? "0" : condition.substr(1))));
  }
  return (line.front() == "leaf" ? "Leaf " : "Window ") + joined(multiples);
}

std::string evidence(const Certificate &c) {
  if (const std::optional<Words> scale = c.find("scale")) {
    const std::optional<Words> chain = c.find("chain");
    return fmt::format("Exact {} ({}) ({})", coq(number(scale->front())), optional_number(c, "above"),
                       chain ? "Some " + joined(*chain) : "None");
  }
  std::vector<std::string> nodes;
  for (const Words &line : c.lines())
    if (line.front() == "split")
      nodes.push_back(split(line));
    else if (line.front() == "leaf" || line.front() == "window")
      nodes.push_back(leaf(line));
  return "Tolerant " + in_lines(nodes);
}

// ---- The theorem ----

/// The statement of the theorem: N, or that there is no match.
std::string claim(const std::string &law, const std::string &particles) {
  if (particles == "none")
    return fmt::format("  forall S : sample, ~ allowed {} asked_question sieves S", law);
  return fmt::format(R"(  least_number {0} asked_question sieves {1} /\
  (* Such a sample, with one size in each class: quantities and bounds of the sizes. *)
  exists S : sample, allowed {0} asked_question sieves S /\ Z.of_nat (length S) = {1} /\
    describes_articulately (root_of sieves) (rows sieves) S /\
    Forall (line_true (root_of sieves) (classes (rows sieves)) S) classes_of_answer)",
                     law, particles);
}

/// The text in a comment of Coq, in which neither a string begins nor the comment ends.
std::string in_comment(std::string_view text) {
  std::string safe(text);
  std::replace_if(
      safe.begin(), safe.end(), [](char ch) { return ch == '"' || ch == '*'; }, '?');
  return safe;
}

std::string heading(std::string_view file_name, std::string_view command) {
  return fmt::format(R"((* A theorem about the gradation {}, checked by Coq's kernel:

     {}

   The folder is where exactmdm installs its Coq development (README.md there says how to compile it where it has no
   .vo files). To be read: the sieves, the question and the theorem, whose words Spec.v defines. *)

From Coq Require Import ZArith QArith Reals List Ascii.
From Mdm Require Import Numbers Gradation Certificate Checker Spec Sizes Laws Answer.
Import ListNotations.
Open Scope Z_scope.

)",
                     in_comment(file_name), in_comment(command));
}

/// The gradation of the file under `name_of_given`, and as the question has it.
std::string sieves(const Gradation &given, const Match &m, std::string_view name_of_given) {
  std::string text = fmt::format(
      R"((* Each row: opening ({}){}, mass retained on it, factor of the class above it, tolerance in percent. Behind
   the rows: the power to which openings are, and whether the file has tolerances. *)
Definition {} : gradation := {}.

)",
      name(given.unit()), given.root() == 1 ? "" : fmt::format(" to the power {}", given.root()),
      name_of_given, gradation(given));
  if (name_of_given != "sieves")
    text += fmt::format("(* After pan_size, cut_below and size_factor. *)\n"
                        "Definition sieves : gradation := {}.\n\n",
                        gradation(m.gradation));
  return text;
}

std::string theorem(const MassLaw &law, const std::string &particles) {
  const std::string lemma =
      particles == "none" ? "no_match _ _ _ _ _ _ accepted" : "smallest _ _ _ _ _ _ _ accepted";
  if (law.is_sphere())
    return fmt::format("Theorem answer :\n{}.\nProof. exact ({} sphere_law). Qed.\n",
                       claim("sphere", particles), lemma);
  return fmt::format("Theorem answer :\n  forall f : R -> R, power_law {} {} f ->\n{}.\n"
                     "Proof. intros f law. exact ({} law). Qed.\n",
                     law.a, law.b, claim("f", particles), lemma);
}

/// Refuses what Coq would take minutes or hours for: it raises openings, masses and sizes to the power e, and
/// multiplies in quadratic time.
void check_powers(const Match &m) {
  const Gradation &g = m.gradation;
  std::uint64_t bits = std::max({longest_opening(g), longest_part(g.masses()), longest_part(g.factors())});
  if (m.sample)
    for (const std::optional<Enclosure> &size : m.sample->sizes)
      if (size)
        bits = std::max<std::uint64_t>({bits, longest_part(size->lo), longest_part(size->hi)});
  const std::uint64_t e = highest_power(m);
  if (Rational(g.classes()) * Rational(e * bits) * Rational(e * bits) > Rational(max_coq_powers))
    throw InputError(
        fmt::format("the theorem needs powers of {} bits for each of {} classes, and Coq takes too "
                    "long where classes times bits times bits are more than {}: use {} and "
                    "mdm-check-verified, or leave out {}",
                    e * bits, g.classes(), max_coq_powers, option("proof"), option("coq")));
}

} // namespace

std::string coq_evidence(const std::string &certificate) {
  return evidence(Certificate(certificate));
}

std::string coq_file(const Gradation &given, const Match &m, std::string_view file_name,
                     std::string_view command) {
  assert(m.complete);
  check_powers(m);
  const std::string text = certificate(m);
  if (text.size() > max_coq_certificate)
    throw InputError(fmt::format("the certificate has {} bytes, and Coq takes too long for more than {}: use "
                                 "{} and mdm-check-verified, or leave out {}",
                                 text.size(), max_coq_certificate, option("proof"), option("coq")));
  const Certificate c(text);
  const bool is_none = !m.sample;
  const std::string N = is_none ? "none" : coq(*m.particles());
  const bool is_changed = m.question.pan_size || m.question.cut_below || m.question.size_factor != 1;
  const std::string_view name_of_given = is_changed ? "sieves_of_file" : "sieves";

  std::string file = heading(file_name, command) + sieves(given, m, name_of_given);
  file += fmt::format("(* The mass of a size x is x^(a/b); None and 0 demand nothing. *)\n"
                      "Definition asked_question : question := {}.\n\n",
                      question(m, c));
  if (!is_none)
    file += fmt::format("(* Class, quantity, mass together (0: the gradation's), bounds of the size. *)\n"
                        "Definition classes_of_answer : list witness_line := {}.\n\n",
                        witness(c));
  file += fmt::format("Definition evidence : proof := {}.\n\n", evidence(c));
  file += fmt::format(
      "Lemma accepted :\n  judged {} (Certificate asked_question {} evidence) = (Ok tt, Ok sieves).\n"
      "Proof. vm_compute. reflexivity. Qed.\n\n",
      name_of_given, is_none ? "NoMatch []" : fmt::format("(Smallest {}) classes_of_answer", N));
  return file + theorem(m.question.law, N) + "\nPrint Assumptions answer.\n";
}

} // namespace mdm
