#include "trace/photons.hpp"

#include "trace/optics.hpp"
#include "trace/path.hpp"
#include "trace/stoppable.hpp"

#include <algorithm>

namespace pastoso::trace {
namespace {

constexpr int kFewestPhotons = 40'000, kMostPhotons = 250'000, kBatch = 1024;
/// No pixels have these numbers.
constexpr std::uint32_t kLampPhotons = 0xFFFFFFFFU, kOtherPhotons = 0xFFFFFFFEU;
/// On the way of one photon; what is left of its light then is lost.
constexpr int kMostEvents = 10'000;
/// A photon that has less of its power left goes on by chance.
constexpr float kFaint = 0.1F;
/// Cells of the fluence along the longest side of the milk's box, and of the caustics along the square.
constexpr int kFluenceCells = 96, kCausticCells = 512;
/// The square is so many times as wide as the ball around the vessel.
constexpr float kSquareSize = 3.0F;
/// Photons of the lamp begin so many radii of that ball away.
constexpr float kLampDistance = 10.0F;

struct Photon {
    Ray ray;
    glm::vec3 power{0.0F};
    float first_power = 0.0F;  ///< of its largest channel
    unsigned here = kAir;
    bool is_lamps = false;       ///< and has met nothing but clear surfaces, ...
    bool was_deflected = false;  ///< ... at least one
};

/// Where photons leave their light.
struct Gathering {
    const World& world;
    const TableSquare& square;
    LightSums& arrived;
    const grid::BoxShape& cells;
    LightSums& ways;  ///< empty: no fluence is asked for
};

class PhotonWalk {
  public:
    PhotonWalk(const Gathering& gathering, Sampler& sampler)
        : into_(gathering), world_(gathering.world), sampler_(sampler) {}

    void follow(Photon photon) {
        photon.first_power = largest(photon.power);
        for (int event = 0; event < kMostEvents && step(photon); ++event) {
            const float left = largest(photon.power) / (kFaint * photon.first_power);
            if (left >= 1.0F) continue;
            if (!(sampler_.next() < left)) return;
            photon.power /= left;
        }
    }

  private:
    /// One straight segment and what happens at its end; false when it leaves the vessel: what light
    /// comes back from outside is that of other photons.
    bool step(Photon& photon) {
        const World::Event event = world_.next_event(photon.ray, photon.here, sampler_);
        if (world_.is_in_milk(photon.here)) leave_light(photon, event.distance);
        photon.power *= world_.absorbed(photon.here, event.distance, event.milk_m);
        photon.ray.origin += photon.ray.direction * event.distance;
        if (event.is_scattering) {
            photon.power *= world_.optics().milk_albedo;
            photon.ray.direction = isotropic_direction(sampler_.pair());
            photon.is_lamps = false;
            return true;
        }
        switch (event.hit.kind) {
            case SurfaceKind::Clear:
                cross(photon, event.hit);
                return true;
            case SurfaceKind::Milk:
            case SurfaceKind::Solid:
                scatter_on(photon, event.hit);
                return true;
            case SurfaceKind::Table:
                if (photon.is_lamps && photon.was_deflected) arrive(photon);
                return false;
            case SurfaceKind::None:
                return false;
        }
        return false;
    }

    /// At a place of its way by chance, for all of it.
    void leave_light(const Photon& photon, float way_m) {
        if (into_.ways.size() == 0) return;
        const float at_m = sampler_.next() * way_m;
        const glm::ivec3 last(into_.cells.nx - 1, into_.cells.ny - 1, into_.cells.nz - 1);
        const glm::vec3 place = (photon.ray.origin + photon.ray.direction * at_m) / into_.cells.cell_m;
        const glm::ivec3 cell = glm::clamp(glm::ivec3(place), glm::ivec3(0), last);
        const glm::vec3 power = photon.power * world_.absorbed(photon.here, at_m);
        into_.ways.add(
            static_cast<std::size_t>(cell.x + into_.cells.nx * (cell.y + into_.cells.ny * cell.z)),
            power * way_m);
    }

    void arrive(const Photon& photon) {
        const int cell = into_.square.cell(glm::vec2(photon.ray.origin));
        if (cell >= 0) into_.arrived.add(static_cast<std::size_t>(cell), photon.power);
    }

    void cross(Photon& photon, const SurfaceHit& hit) {
        const Crossing crossing = world_.crossing(photon.ray, photon.here, hit);
        photon.was_deflected = true;
        if (crossing.reflects > 0.0F && sampler_.pair().x < crossing.reflects) {
            photon.ray = crossing.reflected_ray(photon.ray);
            return;
        }
        photon.ray = crossing.refracted_ray(photon.ray);
        photon.here = crossing.beyond;
    }

    void scatter_on(Photon& photon, const SurfaceHit& hit) {
        const DullBounce bounce(photon.ray, hit);
        photon.power *= world_.reflectance(hit.kind, photon.ray.origin);
        photon.ray = bounce.ray(sampler_.pair());
        photon.is_lamps = false;
    }

    const Gathering& into_;
    const World& world_;
    Sampler& sampler_;
};

/// Even over the lamp's disc and a disc across its light that the vessel is within.
Photon lamp_photon(const World& world, const Ball& vessel, Sampler& sampler) {
    const Light& light = world.light();
    const glm::vec3 towards = light.towards_lamp(sampler.pair());
    const glm::vec2 place = sampler.pair();
    const glm::vec2 across = cos_sin_of_turns(place.y) * (std::sqrt(place.x) * vessel.radius_m);
    const Frame frame(towards);
    Photon photon;
    photon.ray.origin = vessel.middle_m + frame.u * across.x + frame.v * across.y +
                        towards * (kLampDistance * vessel.radius_m);
    photon.ray.direction = -towards;
    const float area_m2 = kPi * vessel.radius_m * vessel.radius_m;
    photon.power = light.lamp_radiance() * (light.lamp_solid_angle() * area_m2);
    photon.is_lamps = true;
    return photon;
}

/// Even over the convex hull of the cup and the cosine of its directions; what comes in there is found
/// by a path outwards.
Photon other_photon(const World& world, const TraceSettings& settings, const PhotonMaps& maps,
                    Sampler& sampler) {
    const CupSurfaces& cup = *world.cup();
    const CupSurfaces::HullPlace from = cup.hull_place(sampler.next(), sampler.pair());
    const glm::vec3 outwards = cosine_direction(from.outward, sampler.pair());
    const glm::vec3 origin = from.place_m + from.outward * kLift_m;
    Photon photon;
    photon.ray = {origin, -outwards};
    const glm::vec3 radiance =
        radiance_besides_lamp({world, settings, maps}, {origin, outwards}, sampler);
    photon.power = glm::min(radiance, glm::vec3(settings.brightest)) * (kPi * cup.hull_area_m2());
    return photon;
}

grid::BoxShape fluence_cells(const glm::vec3& size_m) {
    const float cell_m = largest(size_m) / kFluenceCells;
    const glm::ivec3 cells = glm::max(glm::ivec3(glm::ceil(size_m / cell_m - 1e-3F)), glm::ivec3(2));
    return {cells.x, cells.y, cells.z, cell_m};
}

std::size_t count_of(const grid::BoxShape& shape) {
    return static_cast<std::size_t>(shape.nx) * shape.ny * shape.nz;
}

class Shooting {
  public:
    Shooting(const World& world, const TraceSettings& settings, core::ThreadPool& pool,
             const std::function<bool()>& stop)
        : world_(world),
          settings_(settings),
          pool_(pool),
          stop_(stop),
          vessel_(*world.vessel_ball()),
          has_fluence_(world.has_fluence()),
          cells_(has_fluence_ ? fluence_cells(world.milk_box_m()) : grid::BoxShape{}),
          ways_(has_fluence_ ? count_of(cells_) : 0),
          count_(std::clamp(settings.width * settings.height, kFewestPhotons, kMostPhotons)) {
        const float size_m = 2.0F * kSquareSize * vessel_.radius_m;
        square_ = {glm::vec2(vessel_.middle_m) - 0.5F * size_m, size_m / kCausticCells, kCausticCells};
    }

    std::optional<PhotonMaps> maps() {
        PhotonMaps maps;
        LightSums arrived(static_cast<std::size_t>(kCausticCells) * kCausticCells);
        const Gathering into{world_, square_, arrived, cells_, ways_};
        const float unit = 1.0F / static_cast<float>(count_);
        const auto of_lamp = [&](Sampler& sampler) { return lamp_photon(world_, vessel_, sampler); };
        if (world_.light().has_lamp() && !shoot(into, kLampPhotons, of_lamp)) return std::nullopt;
        maps.caustics = Caustics(square_, arrived, unit);
        if (!has_fluence_) return maps;
        const auto of_all_else = [&](Sampler& sampler) {
            return other_photon(world_, settings_, maps, sampler);
        };
        if (!shoot(into, kOtherPhotons, of_all_else)) return std::nullopt;
        // Light in the liquid is as much stronger than in air as its index squared; paths leave that
        // out.
        const float index = world_.optics().liquid_ior;
        maps.fluence = FluenceField(cells_, world_.cup()->shape(), ways_, unit / (index * index));
        return maps;
    }

  private:
    /// False when stopped.
    template <class Begin>
    bool shoot(const Gathering& into, std::uint32_t kind, const Begin& begin) {
        const int batches = (count_ + kBatch - 1) / kBatch;
        return run_until_stopped(
            pool_, static_cast<std::size_t>(batches), stop_, [&](std::size_t batch) {
                const int first = static_cast<int>(batch) * kBatch;
                for (int i = first; i < std::min(first + kBatch, count_); ++i) {
                    Sampler sampler(settings_.seed, kind, static_cast<std::uint32_t>(i));
                    const Photon photon = begin(sampler);
                    PhotonWalk(into, sampler).follow(photon);
                }
            });
    }

    const World& world_;
    const TraceSettings& settings_;
    core::ThreadPool& pool_;
    const std::function<bool()>& stop_;
    Ball vessel_;
    bool has_fluence_;
    grid::BoxShape cells_;
    LightSums ways_;
    int count_;
    TableSquare square_;
};

}  // namespace

std::optional<PhotonMaps> shoot_photons(const World& world, const TraceSettings& settings,
                                        core::ThreadPool& pool, const std::function<bool()>& stop) {
    if (!world.vessel_ball()) return PhotonMaps{};
    return Shooting(world, settings, pool, stop).maps();
}

}  // namespace pastoso::trace
