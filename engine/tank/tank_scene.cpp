#include "tank/tank_scene.hpp"

#include "core/error.hpp"
#include "core/value_range.hpp"

#include <string>

namespace pastoso::tank {
namespace {

using T = TankScene;

constexpr TankNumber kNumbers[] = {
    {"cell_m", "m", &T::cell_m, 1e-5, 10.0, "Side of a cell"},
    {"gravity_m_s2", "m/s2", &T::gravity_m_s2, 0.0, 1000.0, "Gravity, downwards"},
    {"viscosity_m2_s", "m2/s", &T::viscosity_m2_s, 0.0, 10.0, "Kinematic viscosity"},
    {"confinement", "", &T::confinement, 0.0, 0.3, "Force that keeps small whirls alive"},
    {"courant", "", &T::courant, 0.1, 1.0, "Longest way of a step, in cells"},
    {"tolerance", "", &T::tolerance, 1e-6, 0.1, "How exact the pressure is solved"},
    {"flip_share", "", &T::flip_share, 0.0, 1.0, "How lively the particles are"},
    {"volume_rate", "", &T::volume_rate, 0.0, 1.0, "How fast a wrong density is mended"},
};

void check_velocity(const std::string& name, const glm::vec3& velocity_m_s) {
    for (const int axis : {0, 1, 2})
        core::check_range(name, static_cast<double>(velocity_m_s[axis]), -kMostSpeed_m_s,
                          kMostSpeed_m_s);
}

/// What has times has both.
template <class Timed>
void check_times(const std::string& name, const Timed& timed) {
    core::check_range(name + ".from_s", timed.from_s, 0.0, kLastTime_s);
    core::check_range(name + ".until_s", timed.until_s, timed.from_s, kLastTime_s);
}

void check_shape_of(const std::string& name, const Shape& shape) {
    try {
        check_shape(shape);
    } catch (const core::InputError& error) {
        throw core::InputError("%1: %2", name, error.message());
    }
}

/// Of a body of liquid, or a jet.
template <class Body>
void check_liquid(const std::string& name, const Body& body) {
    check_shape_of(name, body.shape);
    check_velocity(name + ".velocity_m_s", body.velocity_m_s);
    core::check_range(name + ".milk", static_cast<double>(body.milk), 0.0, 1.0);
}

void check_wind(const Wind& wind) {
    core::check_range("wind.speed_m_s", wind.speed_m_s, 0.0, kMostSpeed_m_s);
    core::check_range("wind.direction_deg", wind.direction_deg, -1e4, 1e4);
    core::check_range("wind.drag_per_s", wind.drag_per_s, 0.0, 1e4);
    check_times("wind", wind);
}

/// Calls check("NAME[i]", item) for every item.
template <class Item, class Check>
void check_each(const std::string& name, const std::vector<Item>& items, Check&& check) {
    for (std::size_t i = 0; i < items.size(); ++i)
        check(name + "[" + std::to_string(i) + "]", items[i]);
}

}  // namespace

std::span<const TankNumber> tank_numbers() {
    return kNumbers;
}

void check_tank(const TankScene& scene) {
    for (const int axis : {0, 1, 2})
        core::check_range("cells", scene.cells[axis], kMinTankCells, kMaxTankCells);
    for (const TankNumber& number : kNumbers)
        core::check_range(number.key, scene.*number.value, number.least, number.most);
    check_each("liquids", scene.liquids, check_liquid<LiquidBody>);
    check_each("solids", scene.solids, check_shape_of);
    check_each("jets", scene.jets, [](const std::string& name, const Jet& jet) {
        check_liquid(name, jet);
        check_times(name, jet);
    });
    check_each("drains", scene.drains, [](const std::string& name, const Drain& drain) {
        check_shape_of(name, drain.shape);
        check_times(name, drain);
    });
    check_wind(scene.wind);
}

}  // namespace pastoso::tank
