#include <mdm/gradation/size_unit.hpp>

#include <algorithm>
#include <array>

namespace mdm {
namespace {

constexpr std::array<std::string_view, 4> size_unit_names = {"mm", "um", "m", "in"};

} // namespace

std::string_view name(SizeUnit unit) {
  return size_unit_names.at(static_cast<std::size_t>(unit));
}

std::optional<SizeUnit> parse_size_unit(std::string_view name) {
  const auto *const found = std::find(size_unit_names.begin(), size_unit_names.end(), name);
  if (found == size_unit_names.end())
    return std::nullopt;
  return static_cast<SizeUnit>(found - size_unit_names.begin());
}

Rational in_mm(SizeUnit unit) {
  switch (unit) {
  case SizeUnit::um:
    return ratio(1, 1000);
  case SizeUnit::m:
    return 1000;
  case SizeUnit::in:
    return ratio(254, 10);
  case SizeUnit::mm:
    break;
  }
  return 1;
}

} // namespace mdm
