// The table of options in JSON, for src/ask/write_modules and the test of options.

#include "ask/option_table.hpp"

#include <iostream>

int main() {
  std::cout << mdm::option_table_json();
}
