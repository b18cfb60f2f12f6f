#include "certificate.hpp"

#include "text.hpp"

#include <algorithm>
#include <charconv>
#include <set>
#include <string>

namespace mdm_check {
namespace {

/// A line that stands at most once, and the kinds of its numbers: `1` and `2` are integers from 1 and 2 up,
/// `d` a decimal above 0, `e` a decimal from 0 up, `p` one from 0 to 100, `r` a rational above 0, `f` the
/// word `file`.
struct Rule {
  std::string_view name, kinds;
  bool optional;
  Numbers Certificate::*numbers;
  bool repeats = false; ///< the kinds may follow again
};

constexpr Rule rules[] = {
    {"mdm-certificate", "1", false, &Certificate::version},
    {"law", "r", false, &Certificate::law},
    {"pan-size", "d", true, &Certificate::pan_size},
    {"cut-below", "d", true, &Certificate::cut_below},
    {"size-factor", "d", true, &Certificate::size_factor},
    {"min-per-class", "1", true, &Certificate::min_per_class},
    {"cylinder", "dde", true, &Certificate::cylinder},
    {"box", "ddde", true, &Certificate::box},
    {"solids-volume", "d", true, &Certificate::solids_volume},
    {"pi", "dd", true, &Certificate::pi},
    {"at-least", "2", true, &Certificate::at_least},
};
constexpr Rule rules_of_tolerance[] = {
    {"retained", "p", true, &Certificate::retained},
    {"retained", "f", true, &Certificate::retained_file},
    {"passing", "p", true, &Certificate::passing},
    {"passing", "f", true, &Certificate::passing_file},
    {"passing-each", "p", true, &Certificate::passing_each, true},
    {"total", "p", true, &Certificate::total},
};
constexpr Rule rule_of_band = {"band", "eee", true, &Certificate::band};
constexpr Rule rule_of_particles = {"particles", "1", false, &Certificate::particles};
constexpr Rule rule_of_scale = {"scale", "r", false, &Certificate::scale};
constexpr Rule rule_of_above = {"above", "r", true, &Certificate::above};

/// Walks over the lines of a certificate and over the words of each.
class Lines {
public:
  explicit Lines(std::string_view text) : rest_(text) { next(); }

  [[noreturn]] void fail(const std::string &what) const { throw Malformed(line_, what); }

  /// Whether the line has this name; if so, steps behind it.
  bool take(std::string_view name) {
    const bool yes = line_.substr(0, line_.find(' ')) == name;
    line_.remove_prefix(yes ? name.size() : 0);
    return yes;
  }
  /// Whether no sample matches, according to this line; if so, goes on to the next.
  bool take_none() {
    const bool yes = line_ == "particles none";
    if (yes)
      next();
    return yes;
  }
  void demand(std::string_view name) {
    if (!take(name))
      fail(quoted(line_) + " instead of the line " + quoted(name) + ": let mdm solve --proof write it again");
  }
  /// False where an optional line is absent.
  bool read(const Rule &rule, Certificate &certificate) {
    const bool file = line_ == std::string(rule.name) + " file";
    if (rule.optional && (file != (rule.kinds == "f") || !take(rule.name)))
      return false;
    if (!rule.optional)
      demand(rule.name);
    Numbers &numbers = certificate.*rule.numbers;
    do
      for (const char kind : rule.kinds)
        numbers.push_back(number(kind));
    while (rule.repeats && !line_.empty());
    demand_form(numbers.size() <= 3 * limit::rows, line_, "more numbers than there are sieves: give fewer");
    end_line();
    return true;
  }

  bool more() const { return !line_.empty(); }
  std::size_t words_left() const {
    return static_cast<std::size_t>(std::count(line_.begin(), line_.end(), ' '));
  }
  std::uint64_t index() { return index(word()); }
  std::uint64_t index(std::string_view text) const {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || end != text.data() + text.size() || (text.size() > 1 && text[0] == '0') ||
        text.size() > 18)
      fail(quoted(text) + " is no index: write an integer of at most 18 digits");
    return value;
  }
  static std::uint32_t narrow(std::uint64_t index) {
    return static_cast<std::uint32_t>(std::min<std::uint64_t>(index, 0xFFFF'FFFF));
  }
  Number number(char kind) {
    const std::string_view text = word();
    if (kind == 'f')
      return {0, text};
    const std::size_t slash = kind == 'r' ? text.find('/') : std::string_view::npos;
    Number number{canonical(text.substr(0, slash), kind == 'd' || kind == 'e' || kind == 'p'), text};
    if (slash != std::string_view::npos) {
      const mpz_class numerator = number.value.get_num();
      const mpz_class denominator = canonical(text.substr(slash + 1), false).get_num();
      if (denominator < 2 || gcd(numerator, denominator) != 1)
        fail(quoted(text) + " is not in lowest terms: write it like 3/2");
      number.value = mpq_class(numerator, denominator);
    }
    const unsigned long least_integer = kind == '2' ? 2 : kind == '1' ? 1 : 0;
    if (number.value < least_integer || (number.value == 0 && kind != 'e' && kind != 'p'))
      fail(quoted(text) + " is too small: raise it, or leave out a line that says nothing");
    if (kind == 'p' && number.value > 100)
      fail(quoted(text) + " is more than 100 percentage points: lower it");
    return number;
  }
  /// A multiplier and its condition; a leaf has no condition twice.
  Multiple multiple(std::set<std::string_view> &conditions) {
    const mpz_class m = number('1').value.get_num();
    const std::string_view name = word();
    const bool has_class = name.size() > 1;
    const std::string_view letters = has_class ? "fFqQrRpPex" : "EmwnN";
    if (name.empty() || letters.find(name[0]) == std::string_view::npos || name.substr(1) == "0")
      fail(quoted(name) + " is no condition: write a letter of the format, and a class where it has one");
    if (!conditions.insert(name).second)
      fail(quoted(name) + " is twice in a leaf: add its multipliers");
    return {m, name[0], has_class ? narrow(index(name.substr(1))) : 0};
  }

  /// The line must be used up; steps to the next one.
  void end_line() {
    demand_form(line_.empty(), line_, "too much on this line: drop what follows its numbers");
    next();
  }
  void end_file() const {
    demand_form(line_.empty() && rest_.empty(), line_, "something follows `end`: drop it");
  }

private:
  void next() {
    const std::size_t end = rest_.find('\n');
    line_ = rest_.substr(0, end);
    demand_form(end != std::string_view::npos, rest_, "the certificate breaks off: end it with a line `end`");
    rest_.remove_prefix(end + 1);
  }
  std::string_view word() {
    demand_form(!line_.empty(), line_, "the line is too short: give all its numbers");
    line_.remove_prefix(1);
    const std::string_view word = line_.substr(0, line_.find(' '));
    line_.remove_prefix(word.size());
    return word;
  }
  /// An integer, or a decimal, in its only form.
  mpq_class canonical(std::string_view text, bool decimal) const {
    const Decimal d = split_decimal(text, '.');
    const std::size_t digits = d.whole.size() + d.fraction.size();
    const bool whole = !d.whole.empty() && (d.whole.size() == 1 || d.whole[0] != '0');
    const bool fraction = d.point.empty() || (decimal && !d.fraction.empty() && d.fraction.back() != '0');
    if (!whole || !fraction || text.size() != digits + d.point.size())
      fail(quoted(text) + " is no number of a certificate: write it like 75" + (decimal ? " or 0.75" : ""));
    demand_form(digits <= limit::certificate_digits, text, "more than 100000 digits: give fewer");
    const mpz_class value(std::string(d.whole) + std::string(d.fraction), 10);
    return value * ten_to(-static_cast<long>(d.fraction.size()));
  }

  std::string_view rest_, line_;
};

/// What section 1 demands beyond the form of single lines, up to the witness.
void demand_meaning(const Certificate &c) {
  const auto demand = [](bool holds, const Numbers &line, const char *what) {
    demand_form(holds, line.empty() ? std::string_view() : line[0].text, what);
  };
  demand(c.version[0].value == 1, c.version, "an unknown version: this checker reads `mdm-certificate 1`");
  const mpq_class &law = c.law[0].value;
  demand(law.get_num() <= 1000 && law.get_den() <= 1000, c.law,
         "a law with numbers above 1000: choose a simpler one");
  demand(c.size_factor.empty() || c.size_factor[0].value != 1, c.size_factor,
         "a factor of 1 says nothing: leave it out");
  int solids = 0;
  for (const Numbers *line : {&c.cylinder, &c.box, &c.solids_volume}) {
    solids += line->empty() ? 0 : 1;
    demand(line->empty() || (law == 3 && solids == 1), *line,
           "solids need `law 3` and one line alone: drop the others");
  }
  const bool needs_pi = !c.box.empty() || !c.solids_volume.empty();
  demand(needs_pi != c.pi.empty(), c.law, "`pi` belongs to `box` and `solids-volume`: give both");
  if (!c.pi.empty())
    demand(std::max(c.pi[0].text.size(), c.pi[1].text.size()) <= 1002 && c.pi[0].value >= 3 &&
               c.pi[0].value < c.pi[1].value && c.pi[1].value <= 4,
           c.pi, "bounds of pi must be 3 <= p < r <= 4 with at most 1000 digits after the point");
  for (std::size_t i = 3; i < c.band.size(); i += 3)
    demand_form(c.band[i - 3].value < c.band[i].value, c.band[i].text,
                "sieves of a band that do not ascend: sort them");
}

void read_classes(Lines &lines, Certificate &certificate, bool with_masses) {
  std::vector<ClassWitness> &classes = certificate.classes;
  while (lines.take("class")) {
    ClassWitness witness{lines.index(), lines.number('1').value.get_num(),
                         with_masses ? lines.number('r').value : mpq_class(0), lines.number('d').value,
                         lines.number('d').value};
    if (witness.lo > witness.hi || (!classes.empty() && classes.back().index >= witness.index))
      lines.fail("classes that do not ascend, or bounds of a size that do not: sort them");
    if (classes.size() == limit::rows)
      lines.fail("more classes than a gradation can have: drop those that are not there");
    classes.push_back(std::move(witness));
    lines.end_line();
  }
}

/// Reads nodes until every split has its two subtrees.
void read_tree(Lines &lines, std::vector<TreeNode> &tree) {
  std::size_t size = 0;
  const auto grow = [&] {
    if (++size > limit::tree)
      lines.fail("more than 4194304 nodes and multiples of a tree: search for a smaller one");
  };
  for (std::size_t open = 1; open > 0; grow()) {
    TreeNode node;
    if (lines.take("split")) {
      node.j = Lines::narrow(lines.index());
      node.v = lines.number('1').value.get_num();
      ++open;
    } else {
      lines.demand("leaf");
      std::set<std::string_view> conditions;
      for (--open; node.leaf.empty() || lines.more(); grow())
        node.leaf.push_back(lines.multiple(conditions));
    }
    tree.push_back(std::move(node));
    lines.end_line();
  }
}

} // namespace

Certificate read_certificate(std::string_view text) {
  demand_form(text.size() <= limit::certificate_bytes, text, "more than 256 MiB: give a shorter certificate");
  Lines lines(text);
  Certificate certificate;
  for (const Rule &rule : rules)
    lines.read(rule, certificate);
  bool tolerant = false;
  for (const Rule &rule : rules_of_tolerance)
    tolerant = lines.read(rule, certificate) || tolerant;
  while (lines.read(rule_of_band, certificate))
    tolerant = true;
  demand_meaning(certificate);
  if (!tolerant && !certificate.min_per_class.empty() && certificate.min_per_class[0].value == 1)
    lines.fail("min-per-class 1 says nothing of an exact match: leave it out");
  if (!tolerant || !lines.take_none())
    lines.read(rule_of_particles, certificate);
  if (!tolerant)
    lines.read(rule_of_scale, certificate);
  if (!certificate.particles.empty())
    read_classes(lines, certificate, tolerant);
  const Numbers &at_least = certificate.at_least;
  if (tolerant) {
    read_tree(lines, certificate.tree);
  } else if (at_least.empty() || at_least[0].value != certificate.particles[0].value) {
    if (!at_least.empty())
      lines.read(rule_of_above, certificate);
    lines.demand("chain");
    const std::size_t steps = lines.words_left();
    certificate.chain.emplace(steps);
    for (std::uint32_t &step : *certificate.chain)
      step = Lines::narrow(lines.index());
    lines.end_line();
  }
  lines.demand("end");
  lines.end_file();
  return certificate;
}

} // namespace mdm_check
