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

} // namespace mdm
