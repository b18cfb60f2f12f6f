#include "gradation/account_column.hpp"

namespace mdm {
namespace {

/// The bounds of a factor.
class FactorRange {
public:
  explicit FactorRange(std::optional<Rational> factor) {
    if (factor) {
      low_ = *factor;
      high_ = *factor;
    }
  }

  /// Narrows it to the factors that take `first` to `second`; false where none is left.
  bool narrow(const Interval &first, const Interval &second) {
    if (first.hi == 0)
      return second.lo == 0;
    low_ = std::max<Rational>(low_, second.lo / first.hi);
    if (first.lo > 0) {
      const Rational high = second.hi / first.lo;
      high_ = high_ ? std::min<Rational>(*high_, high) : high;
    }
    return !high_ || low_ <= *high_;
  }
  bool is_bounded() const { return low_ > 0 && high_.has_value(); }
  const Rational &low() const { return low_; }
  const Rational &high() const { return *high_; }

private:
  Rational low_ = 0;
  std::optional<Rational> high_;
};

/// The factor from one column to the other, where their units say it.
std::optional<Rational> known_factor(const AccountColumn &first, const AccountColumn &second) {
  if (first.is_share() && second.is_share())
    return Rational(1);
  if (first.meaning.unit == ColumnUnit::mass && second.meaning.unit == ColumnUnit::mass)
    return first.grams != 0 && second.grams != 0 ? Rational(Rational(first.grams) / second.grams)
                                                 : Rational(1);
  return std::nullopt;
}

/// The first sieve up to which, from the sieve before that both columns tell apart, what they retain does not
/// fit; nothing where it fits everywhere.
template <typename Fits>
std::optional<std::size_t> first_misfit(const AccountColumn &first, const AccountColumn &second,
                                        const Fits &fits) {
  std::size_t from = 0;
  for (std::size_t to = 1; to <= first.sieves.size(); ++to) {
    const std::optional<PrintedNumber> a = first.between(from, to), b = second.between(from, to);
    if (a && b && !fits(*a, *b))
      return to - 1;
    if (first.is_station(to) && second.is_station(to))
      from = to;
  }
  return std::nullopt;
}

} // namespace

bool AccountColumn::is_station(std::size_t count) const {
  if (is_retained())
    return true;
  return count == 0 ? meaning.meaning == ColumnMeaning::cumulative || is_share()
                    : sieves[count - 1].has_value();
}

std::optional<PrintedNumber> AccountColumn::between(std::size_t first, std::size_t last) const {
  if (is_retained()) {
    PrintedNumber sum{0, 0};
    for (std::size_t i = first; i < last; ++i) {
      if (!sieves[i])
        return std::nullopt;
      sum = sum + *sieves[i];
    }
    return sum;
  }
  if (!is_station(first) || !is_station(last))
    return std::nullopt;
  const bool passes = meaning.meaning == ColumnMeaning::passing;
  const PrintedNumber above = first > 0 ? *sieves[first - 1] : PrintedNumber{passes ? 100 : 0, 0};
  const PrintedNumber here = last > 0 ? *sieves[last - 1] : PrintedNumber{passes ? 100 : 0, 0};
  return passes ? above - here : here - above;
}

std::vector<Rational> AccountColumn::numbers() const {
  std::vector<Rational> all;
  for (const std::optional<PrintedNumber> &number : sieves)
    if (number)
      all.push_back(number->value);
  return all;
}

std::optional<PrintedNumber> AccountColumn::retained() const {
  return between(0, sieves.size());
}

std::optional<PrintedNumber> AccountColumn::whole() const {
  if (is_share() && !is_retained())
    return PrintedNumber{100, 0};
  const std::optional<PrintedNumber> above = retained();
  return above && below ? std::optional(*above + *below) : above;
}

std::optional<Rational> AccountColumn::passing_percent(std::size_t sieve) const {
  const std::optional<PrintedNumber> above = between(0, sieve + 1), all = whole();
  if (!above || !all || all->value == 0)
    return std::nullopt;
  return Rational(100 * (all->value - above->value) / all->value);
}

ColumnComparison compare(const AccountColumn &first, const AccountColumn &second) {
  ColumnComparison result;
  const std::optional<Rational> known = known_factor(first, second);
  FactorRange factor(known);
  result.disagreement =
      first_misfit(first, second, [&factor](const PrintedNumber &a, const PrintedNumber &b) {
        return factor.narrow(a.range(), b.range());
      });
  if (result.disagreement)
    return result;
  if (!known && second.is_share() && factor.is_bounded())
    result.whole = Interval(100 / factor.high(), 100 / factor.low());
  return result;
}

bool may_have_shares(const AccountColumn &masses, const AccountColumn &shares) {
  const std::optional<PrintedNumber> whole = masses.whole();
  if (!whole || !masses.below || !masses.is_retained())
    return true;
  // A part and the rest are rounded apart: the part is the largest share where it is most and the rest least.
  const auto may_be = [&whole](const PrintedNumber &part, const PrintedNumber &percent) {
    const Interval here = part.range(), share = percent.range(),
                   rest = PrintedNumber{whole->value - part.value, whole->half - part.half}.range();
    return share.lo * (here.hi + rest.lo) <= 100 * here.hi && 100 * here.lo <= share.hi * (here.lo + rest.hi);
  };
  return !first_misfit(masses, shares, may_be);
}

} // namespace mdm
