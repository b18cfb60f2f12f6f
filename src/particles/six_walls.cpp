#include "particles/six_walls.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace mdm {
namespace {

/// The walls across an axis.
struct Pair {
  const char *axis, *low, *high;
  int number;            ///< of the axis, from 1 on
  const char *turned;    ///< how a square across z comes across the axis
  const char *area;      ///< of each wall
  const char *direction; ///< along the axis, with @speed@
};

constexpr std::array<Pair, 3> pairs_of_walls = {
    {{"x", "west", "east", 1, " rotate axis 0 1 0 angle 90", "v_length_y*v_length_z", "@speed@ 0 0"},
     {"y", "south", "north", 2, " rotate axis 1 0 0 angle 90", "v_length_x*v_length_z", "0 @speed@ 0"},
     {"z", "bottom", "top", 3, "", "v_length_x*v_length_y", "0 0 @speed@"}}};

/// The text for each wall, with @wall@, and for both together.
template <class Text>
std::string of_each_wall(Text text) {
  std::string all;
  for (const Pair &pair : pairs_of_walls)
    for (const char *const wall : {pair.low, pair.high})
      all += text(pair, wall);
  return all;
}

/// Inside of the box that LIGGGHTS keeps, which loses corners on its sides.
constexpr double room_by_wall = 1.05;

const char *const a_wall =
    R"(if "${go_on} == 0" then "variable @wall@_now equal @at@" "variable @wall@_offset equal 0"
fix @wall@ all mesh/surface/stress file @base@-wall.stl type @type@@turned@ move @place@
variable @wall@_start equal ${@wall@_now}
variable @wall@_moved equal f_@wall@[@way@]
variable @wall@ equal v_@wall@_start+f_@wall@[@way@]-v_@wall@_offset
)";

const char *const a_pair = R"(variable length_@axis@ equal v_@high@-v_@low@
variable sigma_@axis@ equal (abs(f_@low@[@force@])+abs(f_@high@[@force@]))/(2*@area@)
)";

const char *const a_move = R"(variable speed equal (${rate}+${rate_@axis@})*${length_@axis@}/2
variable back equal -${speed}
fix move_@low@ all move/mesh mesh @low@ linear @forth@
fix move_@high@ all move/mesh mesh @high@ linear @back@
)";

std::array<double, 3> sides_of_box(const SettleScript &s) {
  return {s.box.x, s.box.y, s.box.z};
}

std::string wall_setting(const SettleScript &s, const Pair &pair, const std::string &wall) {
  const std::size_t axis = static_cast<std::size_t>(pair.number) - 1;
  const std::array<double, 3> sides = sides_of_box(s);
  std::string place;
  for (std::size_t i = 0; i < sides.size(); ++i)
    place += (i > 0 ? " " : "") + (i == axis ? "${" + wall + "_now}" : digits17(sides.at(i) / 2));
  return filled(a_wall, {{"wall", wall},
                         {"at", wall == pair.low ? "0" : digits17(sides.at(axis))},
                         {"base", s.name},
                         {"type", std::to_string(s.types())},
                         {"turned", pair.turned},
                         {"place", place},
                         {"way", std::to_string(pair.number + 6)}});
}

std::string along(const Pair &pair, const char *speed) {
  return filled(pair.direction, {{"speed", speed}});
}

} // namespace

std::string six_walls_room(const SettleScript &s) {
  const std::array<double, 3> sides = sides_of_box(s);
  const double half = room_by_wall * wall_by_box / 2 * *std::max_element(sides.begin(), sides.end());
  std::string text = "# The walls are wider than the box.\nif \"${go_on} == 0\" then \"change_box all";
  for (const Pair &pair : pairs_of_walls) {
    const double middle = sides.at(static_cast<std::size_t>(pair.number) - 1) / 2;
    text += fmt::format(" {} final {} {}", pair.axis, digits17(middle - half), digits17(middle + half));
  }
  return text + " units box\"\n";
}

std::string six_walls_setting(const SettleScript &s, const std::string &contact) {
  std::string text = "# Walls across x, y and z: meshes that move from where they are. A restart has the "
                     "ways that they had before.\n";
  text += of_each_wall([&s](const Pair &pair, const char *wall) { return wall_setting(s, pair, wall); });
  text += "fix walls " + contact + " mesh n_meshes 6 meshes" +
          of_each_wall([](const Pair &, const char *wall) { return std::string(" ") + wall; }) + "\n";
  for (const Pair &pair : pairs_of_walls)
    text += filled(a_pair, {{"axis", pair.axis},
                            {"low", pair.low},
                            {"high", pair.high},
                            {"force", std::to_string(pair.number)},
                            {"area", pair.area}});
  return text + "variable volume equal v_length_x*v_length_y*v_length_z\n"
                "variable pressure equal (v_sigma_x+v_sigma_y+v_sigma_z)/3\n";
}

std::string six_walls_columns() {
  return of_each_wall([](const Pair &pair, const char *wall) {
    return fmt::format(" f_{0}[{1}] f_{0}[{2}]", wall, pair.number, pair.number + 6);
  });
}

std::string six_walls_touched() {
  std::string text;
  for (const Pair &pair : pairs_of_walls)
    text += fmt::format("{0}({1}-c_d/2 < v_{2})+({1}+c_d/2 > v_{3})", text.empty() ? "" : "+", pair.axis,
                        pair.low, pair.high);
  return "\"" + text + "\"";
}

std::string six_walls_move() {
  std::string text;
  for (const Pair &pair : pairs_of_walls)
    text += filled(a_move, {{"axis", pair.axis},
                            {"low", pair.low},
                            {"high", pair.high},
                            {"forth", along(pair, "${speed}")},
                            {"back", along(pair, "${back}")}});
  return text;
}

std::string six_walls_save(const SettleScript &s) {
  return of_each_wall([&s](const Pair &, const char *wall) {
    return fmt::format(
        "print \"variable {0}_now equal ${{{0}}}\" append {1}.restart.state.next screen no\n"
        "print \"variable {0}_offset equal ${{{0}_moved}}\" append {1}.restart.state.next screen no\n",
        wall, s.name);
  });
}

std::string six_walls_removal() {
  std::string text = of_each_wall(
      [](const Pair &, const char *wall) { return fmt::format("variable {0}_end equal ${{{0}}}\n", wall); });
  text += "unfix walls\n";
  text += of_each_wall(
      [](const Pair &, const char *wall) { return fmt::format("unfix move_{0}\nunfix {0}\n", wall); });
  text += "change_box all";
  for (const Pair &pair : pairs_of_walls)
    text += fmt::format(" {} final ${{{}_end}} ${{{}_end}}", pair.axis, pair.low, pair.high);
  return text + " units box\n";
}

} // namespace mdm
