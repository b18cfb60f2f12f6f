#include "standard_streams.hpp"

#include <fcntl.h>
#include <io.h>
#include <windows.h>

namespace mdm::checker {

void settle_streams() {
  constexpr int standard_error = 2;
  for (int descriptor = 0; descriptor <= standard_error; ++descriptor)
    _setmode(descriptor, _O_BINARY);
  SetConsoleOutputCP(CP_UTF8);
}

} // namespace mdm::checker
