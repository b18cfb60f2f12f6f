// The same for tree certificates: what passes must still prove its claim. The judge of this file writes every
// condition out in all variables, in fractions, and adds them up as they stand.

#include "catch.hpp"
#include "mutants.hpp"
#include "window_judge.hpp"

#include <mdm/checker.hpp>

namespace tree_mutations_test {

using namespace mdm_check_test;

namespace {

using Row = std::vector<Rational>;

struct Condition {
  Row of; ///< coefficients of q_1..q_k, t_1..t_k, p_1..p_k
  Rational right = 0;
  bool strict = false;
};

Row sum(const Row &x, const Rational &factor, const Row &y) {
  Row result = x;
  for (std::size_t i = 0; i < x.size(); ++i)
    result[i] += factor * y[i];
  return result;
}

/// Judges a certificate by definition. Refused stands for malformed as well.
class TreeJudge {
public:
  TreeJudge(Table table, const std::string &certificate) : table_(std::move(table)) {
    for (const std::string &line : lines_of(certificate)) {
      Words words;
      std::istringstream input(line);
      for (std::string word; input >> word;)
        words.push_back(word);
      well_formed_ = well_formed_ && line == joined(words, " ") + "\n" && !words.empty();
      lines_.push_back(words);
    }
    well_formed_ = well_formed_ && certificate.find('\0') == std::string::npos && !certificate.empty() &&
                   certificate.back() == '\n';
  }

  bool proves() {
    return well_formed_ && read_question() && derive() && read_witness() && tree_holds() &&
           next_ == lines_.size();
  }

  /// Whether it met a class of a window with more counts than it tries.
  bool gave_up() const { return too_many_; }

private:
  bool is(const std::string &name) const { return next_ < lines_.size() && lines_[next_][0] == name; }

  /// The numbers of the next line, if it has this name and so many; only some may be fractions.
  std::optional<Row> take(const std::string &name, std::size_t count, const std::string &kinds) {
    if (!is(name) || (count > 0 && lines_[next_].size() != count + 1))
      return std::nullopt;
    Row numbers;
    const Words &words = lines_[next_];
    for (std::size_t i = 1; i < words.size(); ++i) {
      const char kind = kinds[std::min(i, kinds.size()) - 1];
      const std::optional<Rational> value = value_of(words[i]);
      if (!value || (kind != 'r' && words[i].find('/') != std::string::npos) ||
          (kind == 'i' && words[i].find('.') != std::string::npos) ||
          (kind == 'r' && words[i].find('.') != std::string::npos))
        return std::nullopt;
      numbers.push_back(*value);
    }
    ++next_;
    return numbers;
  }

  bool read_question() {
    const std::optional<Row> version = take("mdm-certificate", 1, "i"), law = take("law", 1, "r");
    if (!version || (*version)[0] < 1 || (*version)[0] > 3 || !law || (*law)[0] <= 0 || (*law)[0] > 1000 ||
        (*law)[0].get_den() != 1)
      return false;
    second_ = (*version)[0] >= 2;
    third_ = (*version)[0] == 3;
    a_ = (*law)[0].get_num().get_ui();
    for (const char *name : {"min-per-class", "cylinder", "at-least"}) {
      if (!is(name))
        continue;
      const bool cylinder = std::string(name) == "cylinder";
      const std::optional<Row> numbers = take(name, cylinder ? 3 : 1, cylinder ? "d" : "i");
      const int least = std::string(name) == "at-least" ? 2 : 1;
      if (!numbers || (!cylinder && (*numbers)[0] < least) ||
          (cylinder && ((*numbers)[0] <= 0 || (*numbers)[1] <= 0 || a_ != 3)))
        return false;
      question_[name] = *numbers;
    }
    for (const char *name : {"retained", "passing", "passing-each", "total"})
      if (is(name)) {
        const bool each = std::string(name) == "passing-each";
        const int most = std::string(name) == "total" ? 200 : 100; // a sum of deviations is at most 200
        const std::optional<Row> numbers = take(name, each ? 0 : 1, "d");
        if (!numbers || numbers->empty() || *std::max_element(numbers->begin(), numbers->end()) > most)
          return false;
        question_[name] = *numbers;
      }
    while (is("band")) {
      const std::optional<Row> numbers = take("band", 3, "d");
      if (!numbers || (!band_.empty() && (*numbers)[0] <= band_.back()[0]))
        return false;
      band_.push_back(*numbers);
    }
    return !band_.empty() || has("retained") || has("passing") || has("passing-each") || has("total");
  }

  bool has(const char *name) const { return question_.count(name) > 0; }

  static void narrow(Bounds &bounds, const Rational &lo, const Rational &hi) {
    bounds = {std::max(bounds.first, lo), std::min(bounds.second, hi)};
  }

  bool derive() {
    const std::vector<Rational> &x = table_.x;
    k_ = x.size() - 1;
    Rational whole = 0, passed = 0;
    for (const Rational &m : table_.m)
      whole += m;
    retained_ = passing_ = std::vector<Bounds>(k_, {0, 1});
    if (has("passing-each") && question_["passing-each"].size() != k_ - 1)
      return false;
    for (std::size_t j = 0; j < k_; ++j) {
      g_.push_back(table_.m[j] / whole);
      passed += g_[j];
      if (has("retained"))
        narrow(retained_[j], g_[j] - question_["retained"][0] / 100, g_[j] + question_["retained"][0] / 100);
      for (const char *name : {"passing", "passing-each"})
        if (has(name) && j + 1 < k_) {
          const Rational e = question_[name][name == std::string("passing") ? 0 : j] / 100;
          narrow(passing_[j], passed - e, passed + e);
        }
    }
    for (const Row &band : band_) {
      const Rational size = to_power(band[0], table_.root);
      if (size <= x[0] && band[1] != 0)
        return false;
      if (size <= x[0])
        continue;
      const auto found = std::find(x.begin(), x.end(), size);
      if (found == x.end() && size < x.back())
        return false;
      narrow(passing_[found == x.end() ? k_ - 1 : static_cast<std::size_t>(found - x.begin()) - 1],
             band[1] / 100, band[2] / 100);
    }
    if (has("total"))
      total_ = question_["total"][0] / 100;
    if (has("cylinder")) {
      const Row &c = question_["cylinder"];
      weight_ = 3 * c[0] * c[0] * c[1] / (2 * (1 + c[2]));
    }
    for (std::size_t j = 0; j < k_; ++j)
      least_.push_back(has("min-per-class") && table_.m[j] > 0 ? question_["min-per-class"][0] : Rational(0));
    most_.assign(k_, -1);
    for (const Rational &opening : x) {
      const std::optional<Rational> mass = rational_root(to_power(opening, a_), table_.root);
      if (!mass)
        return false;
      masses_.push_back(*mass);
    }
    return true;
  }

  const Rational &mass(std::size_t opening) const { return masses_[opening]; }

  /// `N`, or with version 2 `B..N` or `B..`: the numbers of the witness and of the bound.
  bool read_claim() {
    if (!is("particles") || lines_[next_].size() != 2)
      return false;
    const std::string text = lines_[next_++][1];
    const std::size_t dots = text.find("..");
    const std::string least = text.substr(0, dots);
    const std::string most = dots == std::string::npos ? text : text.substr(dots + 2);
    if (!is_integer_text(least) || (!most.empty() && !is_integer_text(most)))
      return false;
    B_ = Rational(least);
    if (!most.empty())
      N_ = Rational(most);
    const bool single = dots == std::string::npos;
    return *B_ >= (N_ ? 1 : 2) && (single || (second_ && (!N_ || *B_ < *N_)));
  }

  bool read_witness() {
    if (lines_.size() > next_ && joined(lines_[next_], " ") == "particles none") {
      ++next_;
      return true;
    }
    if (!read_claim())
      return false;
    if (!N_)
      return true;
    Row q(k_), t(k_);
    Rational count = 0, M = 0, weight = 0, off = 0, P = 0, last = 0;
    while (is("class")) {
      const std::optional<Row> line = take("class", 5, "iirdd");
      if (!line || (*line)[0] <= last || (*line)[0] > static_cast<unsigned long>(k_) || (*line)[1] < 1)
        return false;
      last = (*line)[0];
      const std::size_t j = last.get_num().get_ui() - 1;
      q[j] = (*line)[1];
      t[j] = (*line)[2];
      const Rational &lo = (*line)[3], &hi = (*line)[4], T = t[j] / q[j];
      const bool inside = lo == hi ? to_power(lo, a_) == T : to_power(lo, a_) <= T && T < to_power(hi, a_);
      const bool in_class = table_.x[j] < to_power(lo, table_.root) &&
                            to_power(hi, table_.root) <= table_.x[j + 1] && mass(j) < T && T <= mass(j + 1);
      if (!inside || lo > hi || !in_class || 1'000'000'000 * (hi - lo) > lo)
        return false;
      count += q[j];
      M += t[j];
      weight += t[j];
    }
    for (std::size_t j = 0; j < k_ && M > 0; ++j) {
      P += t[j];
      off += abs(t[j] / M - g_[j]);
      if (q[j] < least_[j] || t[j] < retained_[j].first * M || t[j] > retained_[j].second * M ||
          P < passing_[j].first * M || P > passing_[j].second * M)
        return false;
    }
    return count == *N_ && count >= least_count() && off <= total_ && weight >= weight_;
  }

  Rational least_count() const { return has("at-least") ? question_.at("at-least")[0] : Rational(1); }

  /// The condition of a name, in all variables.
  std::optional<Condition> condition(const std::string &name) const {
    const std::size_t k = k_;
    const auto unit = [k](std::size_t from, std::size_t to) {
      Row row(3 * k);
      std::fill(row.begin() + static_cast<std::ptrdiff_t>(from),
                row.begin() + static_cast<std::ptrdiff_t>(to), 1);
      return row;
    };
    const Row none(3 * k), M = unit(k, 2 * k), counts = unit(0, k);
    if (name == "m")
      return Condition{M, 0, true};
    if (name == "n")
      return Condition{counts, least_count(), false};
    if (name == "N" && B_)
      return Condition{sum(none, -1, counts), 1 - *B_, false};
    if (name == "E")
      return Condition{sum(sum(none, total_ / 2, M), -1, unit(2 * k, 3 * k)), 0, false};
    if (name == "w")
      return Condition{weight_ > 0 ? M : none, weight_, false};
    if (name.find('-') != std::string::npos)
      return condition_of_sum(name);
    const std::optional<Rational> index = value_of(name.size() > 1 ? name.substr(1) : "0");
    if (!index || index->get_den() != 1 || *index < 1 || *index > static_cast<unsigned long>(k) ||
        name.find_first_of("./") != std::string::npos)
      return std::nullopt;
    const std::size_t j = index->get_num().get_ui() - 1;
    const Row q = unit(j, j + 1), t = unit(k + j, k + j + 1), p = unit(2 * k + j, 2 * k + j + 1);
    const Row P = unit(k, k + j + 1);
    switch (name[0]) {
    case 'f':
      return Condition{sum(t, -mass(j), q), 0, least_[j] >= 1};
    case 'F':
      return Condition{sum(sum(none, mass(j + 1), q), -1, t), 0, false};
    case 'q':
      return Condition{q, least_[j], false};
    case 'Q':
      return most_[j] < 0 ? std::nullopt : std::optional(Condition{sum(none, -1, q), -most_[j], false});
    case 'r':
      return Condition{sum(t, -retained_[j].first, M), 0, false};
    case 'R':
      return Condition{sum(sum(none, retained_[j].second, M), -1, t), 0, false};
    case 'p':
      return Condition{sum(P, -passing_[j].first, M), 0, false};
    case 'P':
      return Condition{sum(sum(none, passing_[j].second, M), -1, P), 0, false};
    case 'e':
      return Condition{sum(sum(p, -1, t), g_[j], M), 0, false};
    case 'x':
      return Condition{p, 0, false};
    default:
      return std::nullopt;
    }
  }

  /// The classes of `i-j`, i < j, from 0.
  std::optional<std::pair<std::size_t, std::size_t>> range(const std::string &text) const {
    const std::size_t dash = text.find('-');
    const std::string first = text.substr(0, dash), last = text.substr(dash + 1);
    if (!second_ || !is_integer_text(first) || !is_integer_text(last) || first.size() > 9 || last.size() > 9)
      return std::nullopt;
    const std::size_t i = std::stoul(first), j = std::stoul(last);
    return i < 1 || j <= i || j > k_ ? std::nullopt : std::optional(std::pair(i - 1, j - 1));
  }

  std::optional<Condition> condition_of_sum(const std::string &name) const {
    const auto classes = range(name.substr(1));
    if (!classes)
      return std::nullopt;
    const auto found = sums_.find(*classes);
    const Bounds bounds = found == sums_.end() ? Bounds{0, -1} : found->second;
    Condition c{Row(3 * k_), 0, false};
    for (std::size_t b = classes->first; b <= classes->second; ++b) {
      c.of[b] = name[0] == 'S' ? Rational(-1) : name[0] == 's' ? Rational(1) : Rational(-mass(b));
      c.of[k_ + b] = name[0] == 'd' ? 1 : 0;
    }
    if (name[0] == 's')
      c.right = bounds.first;
    else if (name[0] == 'S')
      c.right = -bounds.second;
    else
      c.strict = bounds.first >= 1;
    const bool known = name[0] == 's' || name[0] == 'd' || (name[0] == 'S' && bounds.second >= 0);
    return known ? std::optional(c) : std::nullopt;
  }

  bool leaf_holds(const Words &words) const {
    Condition all{Row(3 * k_), 0, false};
    std::set<std::string> names;
    for (std::size_t i = 1; i + 1 < words.size(); i += 2) {
      const std::optional<Rational> m = value_of(words[i]);
      const std::optional<Condition> c = condition(words[i + 1]);
      if (!m || *m < 1 || !is_integer_text(words[i]) || !c || !names.insert(words[i + 1]).second)
        return false;
      all = {sum(all.of, *m, c->of), all.right + *m * c->right, all.strict || c->strict};
    }
    return words.size() > 1 && words.size() % 2 == 1 && all.of == Row(3 * k_) &&
           (all.right > 0 || (all.right == 0 && all.strict));
  }

  /// Recursive, as the format says it: these trees are small.
  bool subtree_holds() {
    if (is("leaf"))
      return leaf_holds(lines_[next_++]);
    if (third_ && is("window"))
      return window_holds(lines_[next_++]);
    if (third_ && is("split") && lines_[next_].size() == 3 && lines_[next_][1] == "M")
      return mass_holds(lines_[next_++][2]);
    if (is("split") && lines_[next_].size() == 3 && lines_[next_][1].find('-') != std::string::npos)
      return sum_holds();
    const std::optional<Row> split = take("split", 2, "i");
    if (!split || (*split)[0] < 1 || (*split)[0] > static_cast<unsigned long>(k_) || (*split)[1] < 1)
      return false;
    const std::size_t j = (*split)[0].get_num().get_ui() - 1;
    const Rational &v = (*split)[1];
    const Rational most = most_[j], least = least_[j];
    most_[j] = most < 0 ? Rational(v - 1) : std::min<Rational>(most, v - 1);
    const bool below = subtree_holds();
    most_[j] = most;
    least_[j] = std::max(least, v);
    const bool above = below && subtree_holds();
    least_[j] = least;
    return above;
  }

  /// A split of the mass.
  bool mass_holds(const std::string &text) {
    const std::optional<Rational> v = value_of(text);
    if (!v || *v <= 0 || text.find('.') != std::string::npos)
      return false;
    const Bounds before = window_;
    window_.second = before.second == 0 ? *v : std::min(before.second, *v);
    const bool below = subtree_holds();
    window_ = {std::max(before.first, *v), before.second};
    const bool above = below && subtree_holds();
    window_ = before;
    return above;
  }

  /// A leaf of the window: sum (c_j y_j + e_j q_j) - mu sum (y_j - g_j)^+ >= right.
  struct WindowSum {
    Row c, e;
    Rational mu = 0, right = 0;
  };

  /// m times a condition; false if it is none.
  bool add(WindowSum &sum, const std::string &name, const Rational &m) const {
    if (name == "t" || name == "T" || name == "w") {
      const bool weighs = name == "w" && weight_ == 0;
      const Rational times = weighs ? Rational(0) : name == "T" ? Rational(-m) : m;
      for (Rational &c : sum.c)
        c += times;
      sum.right += name != "w"           ? times
                   : window_.second == 0 ? Rational(0)
                                         : Rational(m * weight_ / window_.second);
    } else if (name == "E") {
      sum.mu += m;
      sum.right -= m * total_ / 2;
    } else if (name[0] == 'p' || name[0] == 'P') {
      const std::optional<Condition> c = condition(name);
      if (!c || name.find('-') != std::string::npos)
        return false;
      const std::size_t last = std::stoul(name.substr(1));
      for (std::size_t j = 0; j < last; ++j)
        sum.c[j] += name[0] == 'p' ? m : Rational(-m);
      sum.right +=
          name[0] == 'p' ? Rational(m * passing_[last - 1].first) : Rational(-m * passing_[last - 1].second);
    } else {
      const std::optional<Condition> c = condition(name);
      const bool of_sum = (name[0] == 's' || name[0] == 'S') && name.find('-') != std::string::npos;
      if (!c || (name != "n" && name != "N" && !of_sum))
        return false;
      for (std::size_t j = 0; j < k_; ++j)
        sum.e[j] += m * c->of[j];
      sum.right += m * c->right;
    }
    return true;
  }

  bool window_holds(const Words &words) {
    WindowSum all{Row(k_), Row(k_)};
    std::set<std::string> names;
    for (std::size_t i = 1; i + 1 < words.size(); i += 2) {
      const std::optional<Rational> m = value_of(words[i]);
      if (!m || *m < 1 || !is_integer_text(words[i]) || !names.insert(words[i + 1]).second ||
          !add(all, words[i + 1], *m))
        return false;
    }
    if (words.size() % 2 == 0)
      return false;
    const std::vector<Bounds> shares = bounds_of_shares(retained_, passing_, g_, total_ / 2);
    bool is_infinite = false, is_reached = true;
    Rational greatest = 0;
    std::size_t empty = 0;
    for (std::size_t j = 0; j < k_; ++j) {
      const WindowClass c{mass(j),   mass(j + 1), shares[j].first, shares[j].second, g_[j],
                          least_[j], most_[j],    window_.first,   window_.second};
      const WindowValue value = window_value(c, all.c[j], all.e[j], all.mu);
      too_many_ = too_many_ || value.kind == WindowValue::too_many;
      empty += value.kind == WindowValue::empty;
      is_infinite = is_infinite || value.kind == WindowValue::infinite;
      greatest += value.value;
      is_reached = is_reached && value.is_reached;
    }
    return empty > 0 || (!is_infinite && (greatest < all.right || (greatest == all.right && !is_reached)));
  }

  /// A split of a sum.
  bool sum_holds() {
    const auto classes = range(lines_[next_][1]);
    const std::string text = lines_[next_++][2];
    if (!classes || !is_integer_text(text) || text == "0")
      return false;
    const Rational v(text);
    const Bounds before = sums_.emplace(*classes, Bounds{0, -1}).first->second;
    sums_[*classes].second = before.second < 0 ? Rational(v - 1) : std::min<Rational>(before.second, v - 1);
    const bool below = subtree_holds();
    sums_[*classes] = {std::max(before.first, v), before.second};
    const bool above = below && subtree_holds();
    sums_[*classes] = before;
    return above;
  }

  bool tree_holds() { return subtree_holds() && is("end") && lines_[next_++].size() == 1; }

  Table table_;
  std::vector<Words> lines_;
  bool well_formed_ = true;
  std::size_t next_ = 0, k_ = 0;
  unsigned long a_ = 1;
  std::map<std::string, Row> question_;
  std::vector<Row> band_;
  std::vector<Bounds> retained_, passing_;
  Row g_, least_, most_, masses_; ///< masses of particles at the openings
  Rational total_ = 2, weight_ = 0;
  std::optional<Rational> N_, B_;                              ///< of the witness, and the bound
  std::map<std::pair<std::size_t, std::size_t>, Bounds> sums_; ///< in force; -1: no upper bound
  bool second_ = false, third_ = false;                        ///< version 2 and above, version 3
  Bounds window_{0, 0};                                        ///< in force; 0: no upper end
  bool too_many_ = false;
};

/// What stands between the version and the claim.
std::string question_of(const std::string &certificate) {
  const std::size_t begin = certificate.find('\n');
  return certificate.substr(begin, certificate.find("particles ") - begin);
}

/// What the certificates of one question claim of its least number; -1 stands for no match that is known.
struct Claims {
  mpz_class least = 0, most = -1;
  bool none = false;
};

void add_claim(Claims &claims, const std::string &certificate) {
  const std::size_t begin = certificate.find("particles ") + 10;
  const std::string text = certificate.substr(begin, certificate.find('\n', begin) - begin);
  claims.none = claims.none || text == "none";
  if (text == "none")
    return;
  const std::size_t dots = text.find("..");
  const std::string most = dots == std::string::npos ? text : text.substr(dots + 2);
  claims.least = std::max<mpz_class>(claims.least, mpz_class(text.substr(0, dots)));
  if (!most.empty())
    claims.most = claims.most < 0 ? mpz_class(most) : std::min<mpz_class>(claims.most, mpz_class(most));
}

/// Demands the judge's verdict on every mutant; the mutants that pass. There is one least number to a
/// question, so all that pass with the same question agree on it.
std::size_t judge_all(const std::string &gradation, const std::set<std::string> &certificates) {
  const Table table = *read_table(gradation);
  std::map<std::string, Claims> claims;
  std::size_t passed = 0, wrong = 0, unjudged = 0;
  for (const std::string &certificate : certificates) {
    TreeJudge judge(table, certificate);
    const bool proves = judge.proves();
    if (judge.gave_up() && ++unjudged > 0)
      continue;
    const mdm::checker::Verdict verdict = mdm::checker::check({"g", gradation}, {"c", certificate});
    const bool accepted = verdict.code == mdm::checker::Verdict::accepted;
    if (accepted != proves && ++wrong <= 3)
      FAIL_CHECK(verdict.line << verdict.reason << "\nbut the judge says " << proves << "\n" << certificate);
    if (!accepted)
      continue;
    ++passed;
    add_claim(claims[question_of(certificate)], certificate);
  }
  CHECK(wrong == 0);
  CHECK(unjudged * 20 <= certificates.size());
  for (const auto &[question, claim] : claims) {
    INFO(question);
    CHECK((claim.none ? claim.most < 0 : claim.most < 0 || claim.least <= claim.most));
  }
  return passed;
}

const char *const names[] = {"by_hand",
                             "strict_where_a_class_is_occupied",
                             "relaxation_at_an_open_bound",
                             "open_bound_between_two_classes",
                             "closed_bound_between_two_classes",
                             "spheres_total",
                             "one_class",
                             "any_sample",
                             "class_without_mass_holds_a_particle",
                             "passing_each_and_more",
                             "band",
                             "band_on_all_sieves",
                             "min_per_class",
                             "min_per_class_1",
                             "at_least",
                             "cylinder",
                             "none_of_a_band",
                             "none_of_an_empty_class",
                             "half_phi_retained",
                             "half_phi_total",
                             "half_phi_band",
                             "sums_by_hand",
                             "sums_of_an_empty_class",
                             "sums_half_phi",
                             "sums_none",
                             "bounds_by_hand",
                             "bounds_at_least",
                             "bound_alone_by_hand",
                             "windows_by_hand",
                             "windows_tied",
                             "windows_total",
                             "windows_cylinder",
                             "windows_sums"};

} // namespace

TEST_CASE("changed tree certificates pass only where they still prove their claim", "[checker]") {
  for (const std::string name : names) {
    INFO(name);
    const std::string gradation = text_of("tree_" + name + ".csv");
    const std::string certificate = text_of("tree_" + name + ".proof");
    std::set<std::string> mutants;
    change_bytes(certificate, mutants);
    shift_numbers(certificate, mutants);
    change_leaves(certificate, mutants);
    rearrange(lines_of(certificate), "", "", "", mutants);
    mutants.erase(certificate);
    CHECK(mutants.size() > 1000);
    REQUIRE(judge_all(gradation, {certificate}) == 1);
    const std::set<std::string> judged = some_of(mutants);
    const std::size_t harmless = judge_all(gradation, judged);
    CHECK(harmless * 10 < judged.size());
  }
}

TEST_CASE("tree certificates of other gradations pass only where they prove their claim", "[checker]") {
  for (const std::string name : names) {
    std::set<std::string> certificates;
    for (const std::string other : names)
      certificates.insert(text_of("tree_" + other + ".proof"));
    INFO(name);
    CHECK(judge_all(text_of("tree_" + name + ".csv"), certificates) >= 1);
  }
}

} // namespace tree_mutations_test
