// A tank of liquid as it stands at the beginning, and what will happen in it, as plain data. Metres,
// seconds, z up; the tank's box begins at the origin.
#pragma once

#include "tank/shape.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace pastoso::tank {

/// How the surface of the liquid is followed.
enum class Method {
    Particles,       ///< particles carry the liquid (FLIP): keeps its volume
    LevelSet,        ///< a signed distance is carried back along the flow
    UpwindLevelSet,  ///< the same by one-sided differences, as in 2009: loses its volume in thin sheets
    ParticleLevelSet,  ///< a level set that is mended by particles on both sides of the surface
};

/// Liquid that is there at the beginning. Where two bodies meet, the later one's colour counts.
struct LiquidBody {
    Shape shape;
    glm::vec3 velocity_m_s{0.0F};
    float milk = 0.0F;  ///< share of milk in it, 0 clear to 1
    friend bool operator==(const LiquidBody&, const LiquidBody&) = default;
};

/// Within `shape` liquid appears, where there is none yet, and moves with the velocity given.
struct Jet {
    Shape shape;
    glm::vec3 velocity_m_s{0.0F};
    float milk = 0.0F;
    double from_s = 0.0, until_s = 1e9;
    friend bool operator==(const Jet&, const Jet&) = default;
};

/// Liquid that comes into `shape` while the drain is open is gone.
struct Drain {
    Shape shape;
    double from_s = 0.0, until_s = 1e9;
    friend bool operator==(const Drain&, const Drain&) = default;
};

/// Air that moves level over the surface and drags the liquid under it along:
///     du/dt = drag (wind - u)  within kWindReach_cells of the surface, for the level components.
struct Wind {
    double speed_m_s = 0.0;      ///< 0: none
    double direction_deg = 0.0;  ///< where it blows to: 0 along x, 90 along y
    double drag_per_s = 4.0;
    double from_s = 0.0, until_s = 1e9;
    friend bool operator==(const Wind&, const Wind&) = default;
};

struct TankScene {
    std::string name;
    glm::ivec3 cells{64, 64, 64};  ///< kMinTankCells to kMaxTankCells along each side
    double cell_m = 0.005;         ///< side of a cell
    Method method = Method::Particles;
    std::uint32_t seed = 1;

    double gravity_m_s2 = 9.81;  ///< downwards
    double viscosity_m2_s = 1e-6;
    double confinement = 0.0;  ///< of vorticity (Fedkiw, Stam and Jensen, SIGGRAPH 2001, epsilon)
    double courant = 0.6;      ///< the longest way of a step, in cells
    double tolerance = 1e-4;   ///< of the pressure: residual against the right-hand side
    double flip_share = 0.97;  ///< what of a particle's own velocity lasts; the rest is the grid's
    double volume_rate = 0.5;  ///< how much of a wrong density a step mends

    std::vector<LiquidBody> liquids;
    std::vector<Shape> solids;
    std::vector<Jet> jets;
    std::vector<Drain> drains;
    Wind wind;

    glm::vec3 size_m() const { return glm::vec3(cells) * static_cast<float>(cell_m); }
    friend bool operator==(const TankScene&, const TankScene&) = default;
};

inline constexpr int kMinTankCells = 8, kMaxTankCells = 256;
inline constexpr float kWindReach_cells = 1.5F;
inline constexpr double kMostSpeed_m_s = 100.0;  ///< of anything that a scene names
inline constexpr double kLastTime_s = 1e9;       ///< until then: without an end

/// A number of the scene: its name in files, unit, range and what it is.
struct TankNumber {
    const char* key;
    const char* unit;  ///< "" of a plain number
    double TankScene::*value;
    double least, most;
    const char* meaning;
};

/// All of them that are not whole numbers, in the order of the struct.
std::span<const TankNumber> tank_numbers();

/// Throws InputError "NAME is VALUE, not between LEAST and MOST" for a number that is none or outside
/// its range ("liquids[0].milk"), and for a shape that cannot be. Times are from 0 to kLastTime_s, an
/// end not before its beginning.
void check_tank(const TankScene& scene);

}  // namespace pastoso::tank
