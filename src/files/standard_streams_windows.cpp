#include "files/descriptors.hpp"
#include "files/standard_streams.hpp"

#include <fcntl.h>
#include <io.h>
#include <windows.h>

namespace mdm {

void occupy_standard_streams() {
  constexpr int standard_error = 2;
  for (int descriptor = 0; descriptor <= standard_error; ++descriptor) {
    if (_get_osfhandle(descriptor) < 0)
      _open("NUL", descriptor == 0 ? _O_WRONLY : _O_RDONLY); // takes the lowest free number: this one
    _setmode(descriptor, _O_BINARY);
  }
  // A console shows UTF-8, and the line of progress takes its own place again.
  SetConsoleOutputCP(CP_UTF8);
  const HANDLE console = GetStdHandle(STD_ERROR_HANDLE);
  if (DWORD mode = 0; GetConsoleMode(console, &mode) != 0)
    SetConsoleMode(console, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
}

void let_writes_fail() {}

void tell(std::string_view text) {
  while (!text.empty()) {
    const std::ptrdiff_t n = write_bytes(2, text);
    if (n < 0)
      return;
    text.remove_prefix(static_cast<std::size_t>(n));
  }
}

} // namespace mdm
