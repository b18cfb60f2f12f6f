#include <mdm/gradation/size_unit.hpp>

namespace mdm {

std::string_view name(SizeUnit unit) {
  switch (unit) {
  case SizeUnit::um:
    return "um";
  case SizeUnit::m:
    return "m";
  case SizeUnit::mm:
    break;
  }
  return "mm";
}

Rational in_mm(SizeUnit unit) {
  switch (unit) {
  case SizeUnit::um:
    return ratio(1, 1000);
  case SizeUnit::m:
    return 1000;
  case SizeUnit::mm:
    break;
  }
  return 1;
}

} // namespace mdm
