// The lines and labels of the triangles, beside the names that texture() decides.

#include "catch.hpp"
#include "soil.hpp"
#include "soil/texture_diagram.hpp"

#include <fmt/format.h>

#include <map>

namespace texture_diagram_test {

using namespace mdm;
using grading_test::curve;

namespace {

/// What texture() says of the parts in percent.
std::string name(TextureSystem system, const TexturePlace &p) {
  const auto percent = [](double value) { return fmt::format("{:.9f}", value); };
  if (system == TextureSystem::folk)
    return *texture(
        system,
        curve({{"0.0001", "0"}, {"0.0625", percent(p[0])}, {"2", percent(p[0] + p[1])}, {"64", "100"}}));
  const bool is_usda = system == TextureSystem::usda;
  return *texture(system, curve({{"0.0001", "0"},
                                 {is_usda ? "0.002" : "0.00390625", percent(p[2])},
                                 {is_usda ? "0.05" : "0.0625", percent(p[1] + p[2])},
                                 {"2", "100"}}));
}

double cross(const TexturePlace &a, const TexturePlace &b, const TexturePlace &c) {
  return (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]);
}

/// True where the two stretches meet.
bool meet(const TexturePlace &a, const TexturePlace &b, const TexturePlace &c, const TexturePlace &d) {
  constexpr double near = 1e-6;
  const double p = cross(a, b, c), q = cross(a, b, d), r = cross(c, d, a), s = cross(c, d, b);
  return p * q <= near && r * s <= near;
}

TexturePlace between(const TexturePlace &a, const TexturePlace &b, double part, double aside) {
  TexturePlace p{};
  const double y = b[1] - a[1], z = b[2] - a[2];
  p[1] = a[1] + part * y - aside * z;
  p[2] = a[2] + part * z + aside * y;
  p[0] = 100 - p[1] - p[2];
  return p;
}

bool is_inside(const TexturePlace &p) {
  return p[0] >= 0 && p[1] >= 0 && p[2] >= 0;
}

const std::map<std::string, TextureSystem> systems = {
    {"folk", TextureSystem::folk}, {"shepard", TextureSystem::shepard}, {"usda", TextureSystem::usda}};

} // namespace

TEST_CASE("between places with different names there is a line", "[texture]") {
  for (const auto &entry : systems) {
    const TextureSystem system = entry.second;
    const TextureDiagram &diagram = texture_diagram(system);
    const auto check = [&](const TexturePlace &p, const TexturePlace &q) {
      if (!is_inside(q) || name(system, p) == name(system, q))
        return;
      const bool has_line = std::any_of(diagram.lines.begin(), diagram.lines.end(),
                                        [&](const auto &line) { return meet(line[0], line[1], p, q); });
      CAPTURE(entry.first, p[0], p[1], p[2], q[0], q[1], q[2]);
      CHECK(has_line);
    };
    constexpr double step = 2, off = 0.3; // places off the lines
    for (double y = off; y <= 100; y += step)
      for (double z = off; y + z <= 100; z += step) {
        check({100 - y - z, y, z}, {100 - y - z - step, y + step, z});
        check({100 - y - z, y, z}, {100 - y - z - step, y, z + step});
      }
  }
}

TEST_CASE("on both sides of each line names differ", "[texture]") {
  for (const auto &[words, system] : systems)
    for (const auto &[from, to] : texture_diagram(system).lines)
      for (const double part : {0.02, 0.31, 0.63, 0.98}) {
        const double aside = 1e-5;
        const TexturePlace p = between(from, to, part, aside), q = between(from, to, part, -aside);
        CAPTURE(words, from[0], from[1], from[2], part);
        REQUIRE(is_inside(p));
        REQUIRE(is_inside(q));
        CHECK(name(system, p) != name(system, q));
      }
}

TEST_CASE("each field's label stands in it", "[texture]") {
  for (const auto &[words, system] : systems)
    for (const TextureField &field : texture_diagram(system).fields) {
      CAPTURE(words);
      CHECK(name(system, field.at) == field.name);
    }
  CHECK(texture_diagram(TextureSystem::folk).fields.size() == 15);
  CHECK(texture_diagram(TextureSystem::shepard).fields.size() == 10);
  CHECK(texture_diagram(TextureSystem::usda).fields.size() == 12);
}

} // namespace texture_diagram_test
