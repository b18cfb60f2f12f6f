// tradeoff GRADATION: the least numbers of particles within tolerances, and without the finest classes.

#include <mdm/mdm.hpp>

#include <iostream>

int main(int argc, char **argv) try {
  mdm::TradeoffOptions options;
  options.tolerances = {0, mdm::parse_decimal("0.5"), 1, 2};
  options.limits.node_limit = 10000; // of each search: what is certain by then is shown
  const mdm::Tradeoff t = mdm::tradeoff(mdm::read_gradation_file(argc == 2 ? argv[1] : ""), {}, options);
  for (const mdm::TradeoffRow &row : t.by_tolerance)
    std::cout << "within " << mdm::to_decimal(row.tolerance) << " %: " << row.lower_bound
              << (row.is_optimal() ? "" : " or more") << '\n';
  for (const mdm::TradeoffRow &row : t.by_sieve)
    std::cout << "from " << row.smallest.text() << " mm on: " << row.lower_bound
              << (row.is_optimal() ? "" : " or more") << '\n';
  return 0;
} catch (const mdm::InputError &e) {
  std::cerr << e.what() << '\n';
  return 2;
}
