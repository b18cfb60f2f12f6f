// Certificates that were changed must not pass, unless they still prove what they claim. What that is, this
// file decides by itself: it reads the certificate in its own way, demands that it prints it again byte by
// byte, computes the least number of particles by enumeration of all scales where a count changes, and
// replays the chain in fractions.

#include "catch.hpp"
#include "mutants.hpp"

#include <mdm/checker.hpp>

namespace mutations_test {

using namespace mdm_check_test;

namespace {

/// Judges a certificate by definition, in fractions and by enumeration.
class Judge {
public:
  Judge(Table table, const std::string &certificate) : table_(std::move(table)), text_(certificate) {}

  bool proves() { return read() && derive() && witness_holds() && chain_holds() && claim_is_true(); }

private:
  struct Sizes {
    std::size_t index;
    Rational q, lo, hi;
  };

  bool has(const std::string &keyword) const { return lines_.count(keyword) == 1; }
  const Rational &number(const std::string &keyword, std::size_t i = 0) const {
    return lines_.at(keyword).at(i);
  }

  bool read() {
    std::istringstream input(text_);
    std::ostringstream printed;
    std::string line;
    const Words order{"mdm-certificate", "law",       "pan-size", "cut-below",     "size-factor",
                      "min-per-class",   "cylinder",  "box",      "solids-volume", "pi",
                      "at-least",        "particles", "scale",    "class",         "above",
                      "chain",           "end"};
    const Words fractions{"law", "scale", "above"};
    const Words decimals{"pan-size", "cut-below", "size-factor", "cylinder", "box", "solids-volume", "pi"};
    const std::map<std::string, std::size_t> lengths{
        {"cylinder", 3}, {"box", 4}, {"pi", 2}, {"class", 4}, {"end", 0}};
    std::size_t next = 0;
    while (std::getline(input, line)) {
      std::istringstream words(line);
      std::string keyword, word;
      words >> keyword;
      const auto place =
          static_cast<std::size_t>(std::find(order.begin(), order.end(), keyword) - order.begin());
      if (place == order.size() || place + 1 < next || (place + 1 == next && keyword != "class"))
        return false;
      next = place + 1;
      printed << keyword;
      std::vector<Rational> values;
      while (words >> word) {
        printed << ' ';
        if (const std::size_t dots = word.find(".."); keyword == "particles" && dots != std::string::npos) {
          if (!is_integer_text(word.substr(0, dots)))
            return false;
          bound_ = value_of(word.substr(0, dots));
          printed << *bound_ << "..";
          word.erase(0, dots + 2);
        }
        const std::optional<Rational> value = value_of(word);
        const bool fraction = std::find(fractions.begin(), fractions.end(), keyword) != fractions.end();
        const bool decimal = std::find(decimals.begin(), decimals.end(), keyword) != decimals.end() ||
                             (keyword == "class" && values.size() >= 2);
        if (!value || (word.find('/') != std::string::npos && !fraction) ||
            (word.find('.') != std::string::npos && !decimal))
          return false;
        values.push_back(*value);
        printed << word;
      }
      printed << '\n';
      const auto length = lengths.find(keyword);
      if (keyword != "chain" && values.size() != (length == lengths.end() ? 1 : length->second))
        return false;
      if (keyword == "class") {
        if (!sizes_.empty() && values[0] <= static_cast<unsigned long>(sizes_.back().index))
          return false;
        if (values[0] > 1000 || values[1] < 1 || values[2] <= 0 || values[3] < values[2])
          return false;
        sizes_.push_back({values[0].get_num().get_ui(), values[1], values[2], values[3]});
      } else {
        lines_[keyword] = values;
      }
    }
    for (const char *keyword : {"mdm-certificate", "law", "particles", "scale", "end"})
      if (!has(keyword))
        return false;
    return printed.str() == text_ && number("mdm-certificate") == (bound_ ? 2 : 1) &&
           question_is_well_formed();
  }

  bool question_is_well_formed() const {
    for (const auto &line : lines_)
      for (std::size_t i = 0; i < line.second.size() && line.first != "chain"; ++i)
        if (line.second[i] <= 0 &&
            !(i > 0 && i + 1 == line.second.size() && (line.first == "cylinder" || line.first == "box")))
          return false;
    const int solids = has("cylinder") + has("box") + has("solids-volume");
    const bool pi = has("box") || has("solids-volume");
    if (solids > 1 || pi != has("pi") || (solids == 1 && number("law") != 3))
      return false;
    if (pi && (number("pi", 0) < 3 || number("pi", 0) >= number("pi", 1) || number("pi", 1) > 4))
      return false;
    if ((has("size-factor") && number("size-factor") == 1) ||
        (has("min-per-class") && number("min-per-class") < 2) || (has("at-least") && number("at-least") < 2))
      return false;
    if (bound_ && (*bound_ < 1 || *bound_ >= number("particles")))
      return false;
    const bool no_chain = has("at-least") && number("at-least") == bound();
    return has("chain") != no_chain && (!has("above") || (has("at-least") && has("chain")));
  }

  /// Whether S is the d-th root of Y, or, where that is irrational, a decimal of at most 15 digits less than
  /// half a unit of the 15th away from it.
  bool names(const Rational &S, const Rational &Y) const {
    if (to_power(S, d_) == Y)
      return true;
    if (rational_root(Y, d_))
      return false;
    Rational unit(1, 100'000'000'000'000);
    for (; S / unit >= 1'000'000'000'000'000; unit *= 10)
      ;
    for (; S / unit < 100'000'000'000'000; unit /= 10)
      ;
    return Rational(S / unit).get_den() == 1 && to_power(S - unit / 2, d_) < Y &&
           Y < to_power(S + unit / 2, d_);
  }

  bool derive() {
    std::vector<Rational> &x = table_.x;
    d_ = table_.root;
    if (has("pan-size")) {
      const Rational size = to_power(number("pan-size"), d_);
      if (x[0] != 0 || size >= x[1])
        return false;
      x[0] = size;
    }
    if (has("cut-below")) {
      const auto cut =
          std::find_if(x.begin(), x.end(), [&](const Rational &Y) { return names(number("cut-below"), Y); });
      if (cut >= x.end() - 1)
        return false;
      table_.m.erase(table_.m.begin(), table_.m.begin() + (cut - x.begin()));
      x.erase(x.begin(), cut);
    }
    if (has("size-factor"))
      for (Rational &opening : x)
        opening *= to_power(number("size-factor"), d_);
    const Rational &law = number("law");
    if (law.get_num() > 1000 || law.get_den() > 1000)
      return false;
    a_ = law.get_num().get_ui();
    b_ = law.get_den().get_ui() * d_;
    Rational W = 0;
    for (std::size_t j = 0; j + 1 < x.size(); ++j) {
      const Rational mass = to_power(table_.m[j], b_);
      if (mass == 0)
        continue;
      used_.push_back(j);
      A_[j] = to_power(x[j], a_) / mass;
      B_[j] = to_power(x[j + 1], a_) / mass;
      W += table_.m[j];
    }
    if (used_.empty())
      return false;
    if (has("cylinder"))
      least_below_ = least_above_ = 3 * number("cylinder") * number("cylinder") * number("cylinder", 1) /
                                    (2 * (1 + number("cylinder", 2)) * W);
    if (has("pi")) {
      if (number("pi", 0) >= pi_below || number("pi", 1) <= pi_above)
        return false;
      Rational V = has("box")
                       ? number("box", 0) * number("box", 1) * number("box", 2) / (1 + number("box", 3))
                       : number("solids-volume");
      least_below_ = 6 * V / (number("pi", 1) * W);
      least_above_ = 6 * V / (number("pi", 0) * W);
    }
    least_below_ = to_power(least_below_, d_);
    least_above_ = to_power(least_above_, d_);
    return true;
  }

  bool witness_holds() const {
    const Rational &S = number("scale");
    Rational sum = 0;
    if (sizes_.size() != used_.size() || S < least_above_)
      return false;
    for (std::size_t i = 0; i < used_.size(); ++i) {
      const std::size_t j = used_[i];
      const Sizes &s = sizes_[i];
      const Rational q = to_power(s.q, b_);
      const Rational T = S * to_power(table_.m[j], b_) / q;
      const bool in_class = s.index == j + 1 && q * A_.at(j) < S && S <= q * B_.at(j) && s.q >= least_count();
      const bool in_interval = s.lo == s.hi ? to_power(s.lo, a_ * d_) == T
                                            : to_power(s.lo, a_ * d_) <= T && T < to_power(s.hi, a_ * d_);
      if (!in_class || !in_interval || table_.x[j] >= to_power(s.lo, d_) ||
          to_power(s.hi, d_) > table_.x[j + 1] || 1'000'000'000 * (s.hi - s.lo) > s.lo)
        return false;
      sum += s.q;
    }
    return sum == number("particles") && (!has("at-least") || sum >= number("at-least"));
  }

  /// Below this no match is claimed to be.
  const Rational &bound() const { return bound_ ? *bound_ : number("particles"); }

  Rational least_count() const { return has("min-per-class") ? number("min-per-class") : Rational(1); }

  /// The least count of class j at a scale above L (or from `least_below_` up).
  Rational count(std::size_t j, const Rational &L) const {
    Rational q = least_count();
    const Rational z = has("above") ? number("above") : Rational(0);
    const auto serves = [&] {
      const Rational end = to_power(q, b_) * B_.at(j);
      const bool solids = has("pi") ? end > least_below_ : end >= least_below_;
      return end > L && end > z && solids;
    };
    // Doubling before stepping back keeps this quick without an integer root.
    if (!serves()) {
      Rational step = 1;
      for (; !serves(); step *= 2)
        q += step;
      for (; step >= 1; step /= 2) {
        q -= step;
        if (q < 1 || !serves())
          q += step;
      }
    }
    return std::max(q, least_count());
  }

  bool chain_holds() const {
    if (!has("chain"))
      return true;
    Rational L = 0;
    for (const Rational &index : lines_.at("chain")) {
      const auto j = std::find_if(used_.begin(), used_.end(),
                                  [&](std::size_t u) { return index == static_cast<unsigned long>(u + 1); });
      if (j == used_.end())
        return false;
      L = to_power(count(*j, L), b_) * A_.at(*j);
    }
    Rational sum = 0;
    for (const std::size_t j : used_) {
      if (!bound_ && to_power(count(j, L), b_) * A_.at(j) > L)
        return false;
      sum += count(j, L);
    }
    if (has("above")) {
      Rational most = 0;
      for (const std::size_t j : used_) {
        if (A_.at(j) == 0)
          return false;
        for (Rational q = 1; to_power(q, b_) * A_.at(j) < number("above"); ++q)
          if (++most >= number("at-least"))
            return false;
      }
    }
    return sum == bound();
  }

  /// No scale has a match of at least M particles and fewer than the bound. Counts change at q^b A_j and q^b
  /// B_j alone, and between two such scales they are what they are at the upper one.
  bool claim_is_true() const {
    const Rational &N = bound();
    const Rational M = has("at-least") ? number("at-least") : Rational(1);
    std::set<Rational> scales{least_above_};
    for (const std::size_t j : used_)
      for (Rational q = 1; q <= N; ++q) {
        scales.insert(to_power(q, b_) * A_.at(j));
        scales.insert(to_power(q, b_) * B_.at(j));
      }
    for (const Rational &S : scales) {
      if (S == 0 || S < least_above_)
        continue;
      Rational fewest = 0, most = 0;
      bool fits = true;
      for (const std::size_t j : used_) {
        Rational q = least_count();
        while (to_power(q, b_) * B_.at(j) < S && q <= N)
          ++q;
        fits = fits && to_power(q, b_) * A_.at(j) < S;
        fewest += q;
        for (; q <= N && to_power(q, b_) * A_.at(j) < S; ++q)
          ;
        most += q - 1;
      }
      if (fits && std::max(fewest, M) < N && most >= M)
        return false;
    }
    return true;
  }

  Table table_;
  std::string text_;
  std::map<std::string, std::vector<Rational>> lines_;
  std::optional<Rational> bound_; ///< where it is not the number of particles
  std::vector<Sizes> sizes_;
  std::vector<std::size_t> used_;
  std::map<std::size_t, Rational> A_, B_;
  Rational least_below_ = 0, least_above_ = 0;
  // Openings are x^d; scales, masses and quantities have the power b, that of the law times d.
  unsigned long a_ = 1, b_ = 1, d_ = 1;
};

/// One more particle in a class, and in the claim.
void claim_more(const std::string &text, std::set<std::string> &mutants) {
  const Words lines = lines_of(text);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].rfind("class ", 0) != 0)
      continue;
    for (const int shift : {-1, 1}) {
      std::string mutant;
      for (std::size_t k = 0; k < lines.size(); ++k) {
        std::istringstream words(lines[k]);
        std::string keyword, index, quantity, rest;
        words >> keyword >> index >> quantity;
        std::getline(words, rest);
        if (keyword == "particles") {
          const std::size_t dots = index.find(".."), behind = dots == std::string::npos ? 0 : dots + 2;
          mutant += "particles " + index.substr(0, behind) +
                    mpz_class(mpz_class(index.substr(behind)) + shift).get_str() + "\n";
        } else if (k == i)
          mutant += "class " + index + " " + mpz_class(mpz_class(quantity) + shift).get_str() + rest + "\n";
        else
          mutant += lines[k];
      }
      mutants.insert(mutant);
    }
  }
}

/// The mutants that pass although they differ; each verdict must be the judge's.
std::size_t judge_all(const std::set<std::string> &gradations, const std::set<std::string> &certificates) {
  std::size_t passed = 0, wrong = 0;
  for (const std::string &gradation : gradations)
    for (const std::string &certificate : certificates) {
      const std::optional<Table> table = read_table(gradation);
      const bool proves = table && Judge(*table, certificate).proves();
      const mdm::checker::Verdict verdict = mdm::checker::check({"g", gradation}, {"c", certificate});
      const bool accepted = verdict.code == mdm::checker::Verdict::accepted;
      if (accepted != proves && ++wrong <= 3)
        FAIL_CHECK(verdict.line << verdict.reason << "\nbut the judge says " << proves << "\n"
                                << gradation << certificate);
      passed += accepted ? 1 : 0;
    }
  CHECK(wrong == 0);
  return passed;
}

const std::vector<std::string> names = {"sphere_two_classes",
                                        "sphere_narrow",
                                        "one_class",
                                        "pan_alone",
                                        "power_3_2",
                                        "power_1_2",
                                        "exact_sizes",
                                        "exact_sizes_in_decimals",
                                        "pan_at_zero",
                                        "pan_size_that_binds",
                                        "pan_cut_factor",
                                        "interior_zeros",
                                        "cylinder_exactly_full",
                                        "solids_volume_and_min_per_class",
                                        "at_least_skips_a_gap",
                                        "at_least_power_3_2",
                                        "at_least_cylinder",
                                        "at_least_everything",
                                        "bounds_of_some_steps",
                                        "bounds_of_a_whole_chain",
                                        "bounds_power_3_2",
                                        "bounds_min_per_class",
                                        "bounds_at_least_above_a_scale",
                                        "bounds_at_least_without_a_chain"};
const std::vector<std::string> half_phi_names = {"half_phi_that_ties",
                                                 "half_phi_quarters",
                                                 "half_phi_tenths",
                                                 "half_phi_cut_at_15_digits",
                                                 "half_phi_cut_at_3_of_15_digits",
                                                 "half_phi_cut_leaves_whole_phi",
                                                 "half_phi_bounds",
                                                 "half_phi_at_least_power_3_2",
                                                 "half_phi_pan_factor_cylinder",
                                                 "half_phi_pan_cut_volume"};

std::vector<std::string> all_names() {
  std::vector<std::string> all = names;
  all.insert(all.end(), half_phi_names.begin(), half_phi_names.end());
  return all;
}

void judge_changed(const std::string &name) {
  const std::string gradation = text_of(name + ".csv");
  const std::string certificate = text_of(name + ".proof");
  std::set<std::string> mutants;
  change_bytes(certificate, mutants);
  shift_numbers(certificate, mutants);
  claim_more(certificate, mutants);
  rearrange(lines_of(certificate), "", "", "", mutants);
  const std::size_t chain = certificate.find("\nchain ");
  if (chain != std::string::npos) {
    const std::size_t end = certificate.find('\n', chain + 1);
    Words steps;
    std::istringstream words(certificate.substr(chain + 7, end - chain - 7));
    for (std::string step; words >> step;)
      steps.push_back(step);
    rearrange(steps, " ", certificate.substr(0, chain + 7), certificate.substr(end), mutants);
  }
  mutants.erase(certificate);
  INFO(name);
  CHECK(mutants.size() > 1000);
  REQUIRE(judge_all({gradation}, {certificate}) == 1);
  const std::set<std::string> judged = some_of(mutants);
  const std::size_t harmless = judge_all({gradation}, judged);
  CHECK(harmless * 10 < judged.size());
}

} // namespace

TEST_CASE("changed certificates pass only where they still prove their claim", "[checker]") {
  for (const std::string &name : names)
    judge_changed(name);
}

TEST_CASE("changed certificates of half-phi sieves pass only where they still prove their claim",
          "[checker]") {
  for (const std::string &name : half_phi_names)
    judge_changed(name);
}

TEST_CASE("certificates pass changed gradations only where they still prove their claim", "[checker]") {
  for (const std::string &name : all_names()) {
    const std::string gradation = text_of(name + ".csv");
    const std::size_t header = gradation.find('\n') + 1;
    std::set<std::string> rows;
    shift_numbers(gradation.substr(header), rows);
    rearrange(lines_of(gradation.substr(header)), "", "", "", rows);
    std::set<std::string> mutants;
    for (const std::string &row : rows)
      mutants.insert(gradation.substr(0, header) + row);
    INFO(name);
    judge_all(mutants, {text_of(name + ".proof")});
  }
}

TEST_CASE("no certificate passes another gradation", "[checker]") {
  for (const std::string &name : all_names())
    for (const std::string &other : all_names()) {
      INFO(name << " " << other);
      judge_all({text_of(name + ".csv")}, {text_of(other + ".proof")});
    }
}

} // namespace mutations_test
