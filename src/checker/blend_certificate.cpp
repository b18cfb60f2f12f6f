#include "blend_certificate.hpp"

#include "certificate_lines.hpp"

#include <algorithm>
#include <charconv>
#include <set>
#include <string>
#include <utility>

namespace mdm::checker {
namespace {

constexpr std::uint64_t most_terms = std::uint64_t{1} << 22U, most_numbers = std::uint64_t{1} << 20U;
constexpr std::uint64_t most_steps = 1'000'000'000;

/// The lines of a certificate of a blend, or of none.
class BlendLines : public CertificateLines {
public:
  explicit BlendLines(std::string_view text) : CertificateLines(text, "mdm blend") {}

  std::uint64_t count(std::uint64_t least) {
    const std::string_view text = word();
    std::uint64_t value = 0;
    const char *const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    const bool read = error == std::errc() && stop == end; // beyond 64 bits it is another error
    demand_form(read && !text.empty() && (text == "0" || text[0] != '0') && value <= most_steps, line_,
                "is no count: write an integer of at most 1000000000", text);
    demand_form(value >= least, line_, "is too small: raise it, or leave out a line that says nothing", text);
    return value;
  }
  /// `p/q` in lowest terms, or an integer; from 0 on.
  mpq_class rational() { return rational(word()); }
  mpq_class positive() {
    const std::string_view text = word();
    const mpq_class value = rational(text);
    demand_form(value > 0, line_, "is no multiplier: leave it out", text);
    return value;
  }
  SieveMultiple multiple(bool with_targets) {
    const mpq_class m = positive();
    check(more(), "the line is too short: a condition follows each multiplier");
    line_.remove_prefix(1);
    const char condition = more() ? line_[0] : ' ';
    demand_form(
        condition == 'l' || condition == 'u' || (with_targets && (condition == 'a' || condition == 'b')),
        line_, "is no condition here: write l or u, or a or b of a target, and the number of a sieve");
    // The number is read as a word behind a space.
    std::uint64_t sieve = 0;
    const char *const begin = line_.data() + 1, *const end = line_.data() + line_.size();
    const auto [stop, error] = std::from_chars(begin, end, sieve);
    demand_form(error == std::errc() && *begin != '0' && sieve <= most_numbers &&
                    (stop == end || *stop == ' '),
                line_, "is no sieve: write its number, counted from 1");
    line_.remove_prefix(static_cast<std::size_t>(stop - line_.data()));
    return {m, condition, sieve};
  }
  std::uint64_t longest_bits() const { return longest_bits_; }

private:
  mpz_class natural(std::string_view text) const {
    const bool digits =
        !text.empty() && text.size() <= 100'000 && std::all_of(text.begin(), text.end(), is_digit);
    demand_form(digits && (text == "0" || text[0] != '0'), line_,
                "is no number of this certificate: write an integer, or a fraction like 3/2", text);
    return mpz_class(std::string(text), 10);
  }
  mpq_class rational(std::string_view text) {
    const std::size_t slash = text.find('/');
    mpq_class value = natural(text.substr(0, slash));
    if (slash != std::string_view::npos) {
      const mpz_class denominator = natural(text.substr(slash + 1));
      demand_form(denominator >= 2 && gcd(value.get_num(), denominator) == 1, line_,
                  "is not in lowest terms: write it like 3/2", text);
      value = mpq_class(value.get_num(), denominator);
    }
    longest_bits_ = std::max(longest_bits_, bits(value));
    return value;
  }
  std::uint64_t longest_bits_ = 1;
};

void read_shares(BlendLines &lines, BlendCertificate &c) {
  while (lines.take("share")) {
    ShareLimits limits{lines.count(1), lines.rational(), lines.rational()};
    lines.check(limits.least <= limits.most && limits.most <= 1 && (limits.least > 0 || limits.most < 1),
                "limits of a share that say nothing, or are not in order from 0 to 1: correct them");
    lines.check(c.shares.empty() || c.shares.back().stockpile < limits.stockpile,
                "stockpiles that do not ascend: sort the shares");
    c.shares.push_back(std::move(limits));
    lines.end();
  }
}

void read_moduli(BlendLines &lines, BlendCertificate &c) {
  using Standard = ModulusLimits::Standard;
  for (const auto &[words, standard] :
       {std::pair{"modulus astm", Standard::astm}, std::pair{"modulus en", Standard::en}}) {
    if (!lines.take(words))
      continue;
    ModulusLimits limits{standard, lines.rational(), lines.rational()};
    const mpq_class largest(static_cast<unsigned long>(modulus_sieves(standard).size()));
    lines.check(
        limits.least <= limits.most && limits.most <= largest && (limits.least > 0 || limits.most < largest),
        "limits of a fineness modulus that say nothing, or are not in order from 0 to the number of its "
        "sieves: correct them");
    c.moduli.push_back(std::move(limits));
    lines.end();
  }
}

void read_coarseness(BlendLines &lines, BlendCertificate &c) {
  if (!lines.take("coarseness"))
    return;
  c.coarseness = CoarsenessLimits{lines.rational(), lines.rational()};
  const mpq_class &least = c.coarseness->least, &most = c.coarseness->most;
  lines.check(
      least <= most && most <= 100 && (least > 0 || most < 100),
      "limits of a coarseness factor that say nothing, or are not in order from 0 to 100: correct them");
  lines.end();
}

void read_aim(BlendLines &lines, BlendCertificate &c) {
  using Aim = BlendCertificate::Aim;
  constexpr std::pair<const char *, Aim> aims[] = {{"minimise none", Aim::no_aim},
                                                   {"minimise cost", Aim::cost},
                                                   {"minimise deviation", Aim::deviation},
                                                   {"minimise max-deviation", Aim::max_deviation},
                                                   {"minimise squares", Aim::squares}};
  for (const auto &[words, aim] : aims)
    if (lines.take(words)) {
      for (c.aim = aim; lines.more();) {
        lines.check(c.of_aim.size() < most_numbers, "more numbers than there are sieves: give fewer");
        c.of_aim.push_back(lines.rational());
      }
      lines.check((aim == Aim::no_aim) == c.of_aim.empty(),
                  "an aim with numbers that it does not have: correct it");
      lines.end();
      return;
    }
  lines.demand("minimise");
}

/// Reads nodes until every split has its two subtrees.
void read_tree(BlendLines &lines, BlendCertificate &c) {
  const auto grow = [&] {
    lines.check(++c.terms <= most_terms, "more than 4194304 nodes and multiples: search for a smaller tree");
  };
  for (std::size_t open = 1; open > 0; grow()) {
    BlendNode node{BlendNode::none, 0, 0, {}};
    if (lines.take("split")) {
      node.kind = BlendNode::split;
      node.stockpile = lines.count(1);
      node.at = lines.count(0);
      ++open;
    } else {
      const bool is_leaf = c.blend && lines.take("leaf");
      node.kind = is_leaf ? BlendNode::leaf : BlendNode::none;
      if (!is_leaf)
        lines.demand("none");
      std::set<std::pair<char, std::uint64_t>> conditions;
      for (--open; lines.more(); grow()) {
        node.multiples.push_back(lines.multiple(is_leaf && c.has_targets()));
        const SieveMultiple &m = node.multiples.back();
        lines.check(conditions.emplace(m.condition, m.sieve).second,
                    "a condition is twice in a leaf: add its multipliers");
      }
      c.longest_leaf = std::max<std::uint64_t>(c.longest_leaf, node.multiples.size());
    }
    lines.end();
    c.tree.push_back(std::move(node));
  }
}

} // namespace

const Rationals &modulus_sieves(ModulusLimits::Standard standard) {
  static const Rationals astm = {mpq_class(3, 20),  mpq_class(3, 10), mpq_class(3, 5),  mpq_class(59, 50),
                                 mpq_class(59, 25), mpq_class(19, 4), mpq_class(19, 2), mpq_class(19),
                                 mpq_class(75, 2),  mpq_class(75),    mpq_class(150)};
  static const Rationals en = {mpq_class(1, 8), mpq_class(1, 4), mpq_class(1, 2),
                               mpq_class(1),    mpq_class(2),    mpq_class(4)};
  return standard == ModulusLimits::astm ? astm : en;
}

BlendCertificate read_blend_certificate(std::string_view text) {
  BlendLines lines(text);
  BlendCertificate c;
  lines.demand("mdm-certificate blend 1");
  lines.end();
  lines.demand("steps");
  c.steps = lines.count(1);
  lines.end();
  read_shares(lines, c);
  if (lines.take("at-most")) {
    c.at_most = lines.count(1);
    lines.end();
  }
  read_moduli(lines, c);
  read_coarseness(lines, c);
  read_aim(lines, c);
  lines.demand("blend");
  if (!lines.take(" none")) {
    for (c.blend.emplace(); lines.more();) {
      lines.check(c.blend->size() < most_numbers, "more stockpiles than can be: give fewer");
      c.blend->push_back(lines.count(0));
    }
  }
  lines.end();
  if (!c.blend || c.aim != BlendCertificate::no_aim)
    read_tree(lines, c);
  lines.demand("end");
  lines.end_file();
  c.longest_bits = lines.longest_bits();
  return c;
}

} // namespace mdm::checker
