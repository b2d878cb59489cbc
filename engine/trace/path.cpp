#include "trace/path.hpp"

#include "trace/optics.hpp"

namespace pastoso::trace {
namespace {

/// At the first clear surfaces from the camera, both the reflected and the refracted path are followed:
/// the glass' edges and highlights are what one sees most of it.
constexpr int kSplits = 2;
/// A share smaller than this is not worth a path of its own.
constexpr float kLeastSplit = 0.01F;
/// Events before paths are ended by chance.
constexpr int kSureEvents = 6;
/// What red, green and blue count for when paths are ended by chance: deep in tea red alone is left.
const glm::vec3 kEyeWeights(0.3F, 0.5F, 0.2F);
/// Scatterings at which the lamp is looked for in any case, and the chance at those after them.
constexpr int kSureLamps = 1;
constexpr float kRareLamps = 0.25F;
/// Scatterings that a path goes through itself; what light comes to the next in milk is taken from the
/// photons, whose cells are then too small to be seen.
constexpr int kOwnScatterings = 2;

struct Strand {
    Ray ray;
    glm::vec3 weight{1.0F};
    float share = 1.0F;  ///< of the weight that splitting alone has left
    unsigned here = kAir;
    int events = 0;
    int scatterings = 0;
    int splits_left = kSplits;
    bool meets_lamp = true;  ///< otherwise it has been sought where the strand scattered last
    bool describes = true;   ///< features are still missing
};

class Follower {
  public:
    Follower(const Lit& lit, Sampler& sampler, std::uint64_t& rays)
        : world_(lit.world), settings_(lit.settings), maps_(lit.maps), sampler_(sampler), rays_(rays) {}

    PathResult follow(const Ray& ray, bool meets_lamp) {
        Strand strand;
        strand.ray = ray;
        strand.meets_lamp = meets_lamp;
        run(strand);
        while (waiting_ > 0)
            run(waiting_strands_[--waiting_]);
        return result_;
    }

  private:
    void run(Strand strand) {
        while (strand.events < settings_.most_events && step(strand)) {
            ++strand.events;
            if (strand.events <= kSureEvents) continue;
            const float stays = std::min(1.0F, glm::dot(strand.weight, kEyeWeights) / strand.share);
            if (sampler_.next() >= stays) return;
            strand.weight /= stays;
        }
    }

    /// One straight segment and what happens at its end; false when the strand ends.
    bool step(Strand& strand) {
        ++rays_;
        const World::Event event = world_.next_event(strand.ray, strand.here, sampler_);
        const SurfaceHit& hit = event.hit;
        if (!event.is_scattering && hit.kind == SurfaceKind::None) {
            arrive(strand);
            return false;
        }
        strand.weight *= world_.absorbed(strand.here, event.distance, event.milk_m);
        strand.ray.origin += strand.ray.direction * event.distance;
        if (event.is_scattering) {
            scatter_in_milk(strand);
        } else {
            if (strand.events == 0) describe_normal(hit);
            if (hit.kind == SurfaceKind::Clear)
                cross(strand, hit);
            else
                scatter_on(strand, hit);
        }
        return largest(strand.weight) > 0.0F;
    }

    void arrive(const Strand& strand) {
        const glm::vec3 light =
            world_.light().from(strand.ray.direction, strand.meets_lamp || !settings_.seeks_lamp);
        if (strand.describes) describe_colour(glm::min(light, glm::vec3(1.0F)));
        result_.radiance += strand.weight * light;
    }

    void describe_normal(const SurfaceHit& hit) {
        for (int axis = 0; axis < 3; ++axis)
            result_.features[3 + axis] = hit.shading[axis];
    }

    void describe_colour(const glm::vec3& colour) {
        for (int channel = 0; channel < 3; ++channel)
            result_.features[channel] = colour[channel];
    }

    /// What scatters is dull: from here on the strand looks for the lamp, and splits no more.
    void become_dull(Strand& strand, const glm::vec3& colour) {
        if (strand.describes) describe_colour(colour);
        strand.describes = false;
        strand.meets_lamp = false;
        strand.splits_left = 0;
        ++strand.scatterings;
    }

    void add_lamp(const Strand& strand, const glm::vec3& arrives, float share) {
        result_.radiance += strand.weight * arrives * world_.light().lamp_radiance() *
                            (world_.light().lamp_solid_angle() * share);
    }

    bool seeks_lamp() const { return settings_.seeks_lamp && world_.light().has_lamp(); }

    /// Light that has been scattered often comes from everywhere alike: then the lamp is looked for now
    /// and then only, and counts the more.
    float chance_to_seek_lamp(const Strand& strand) const {
        return strand.scatterings <= kSureLamps ? 1.0F : kRareLamps;
    }

    void scatter_in_milk(Strand& strand) {
        strand.weight *= world_.optics().milk_albedo;
        if (strand.scatterings >= kOwnScatterings && !maps_.fluence.empty()) {
            result_.radiance += strand.weight * maps_.fluence.at(strand.ray.origin) / (4.0F * kPi);
            strand.weight = glm::vec3(0.0F);
            return;
        }
        become_dull(strand, {0.8F, 0.75F, 0.6F});
        const float chance = seeks_lamp() ? chance_to_seek_lamp(strand) : 0.0F;
        if (chance >= 1.0F || (chance > 0.0F && sampler_.next() < chance)) {
            const Ray ray{strand.ray.origin, world_.light().towards_lamp(sampler_.pair())};
            add_lamp(strand, world_.straight_transmittance(ray, strand.here, sampler_, rays_),
                     1.0F / (4.0F * kPi * chance));
        }
        strand.ray.direction = isotropic_direction(sampler_.pair());
    }

    void scatter_on(Strand& strand, const SurfaceHit& hit) {
        const DullBounce bounce(strand.ray, hit);
        const glm::vec3 colour = world_.reflectance(hit.kind, strand.ray.origin);
        strand.weight *= colour;
        become_dull(strand, colour);
        if (seeks_lamp()) seek_lamp_off(strand, hit, bounce);
        // What shape milk has is not seen in what it lends a dull surface.
        strand.scatterings = std::max(strand.scatterings, kOwnScatterings);
        strand.ray = bounce.ray(sampler_.pair());
    }

    /// To the table it comes straight through air, or else with the photons.
    void seek_lamp_off(const Strand& strand, const SurfaceHit& hit, const DullBounce& bounce) {
        const bool by_photons = hit.kind == SurfaceKind::Table && !maps_.caustics.empty();
        if (by_photons)
            result_.radiance +=
                strand.weight * maps_.caustics.irradiance(glm::vec2(strand.ray.origin)) / kPi;
        const Ray ray{bounce.origin, world_.light().towards_lamp(sampler_.pair())};
        const float cosine = glm::dot(ray.direction, bounce.normal);
        if (cosine <= 0.0F) return;
        if (!by_photons) {
            add_lamp(strand, world_.straight_transmittance(ray, strand.here, sampler_, rays_),
                     cosine / kPi);
            return;
        }
        ++rays_;
        if (world_.is_open(ray)) add_lamp(strand, glm::vec3(1.0F), cosine / kPi);
    }

    void cross(Strand& strand, const SurfaceHit& hit) {
        const Crossing crossing = world_.crossing(strand.ray, strand.here, hit);
        const float share = crossing.reflects;
        Strand bounced = strand;
        bounced.ray = crossing.reflected_ray(strand.ray);
        const bool splits =
            strand.splits_left > 0 && share < 1.0F && share * largest(strand.weight) > kLeastSplit;
        if (!splits && share > 0.0F && (share >= 1.0F || sampler_.pair().x < share)) {
            strand = bounced;
            return;
        }
        if (splits) {
            --strand.splits_left;
            bounced.splits_left = strand.splits_left;
            bounced.weight *= share;
            bounced.share *= share;
            bounced.describes = false;
            ++bounced.events;
            waiting_strands_[waiting_++] = bounced;
            strand.weight *= 1.0F - share;
            strand.share *= 1.0F - share;
        }
        strand.ray = crossing.refracted_ray(strand.ray);
        strand.here = crossing.beyond;
    }

    const World& world_;
    const TraceSettings& settings_;
    const PhotonMaps& maps_;
    Sampler& sampler_;
    std::uint64_t& rays_;
    PathResult result_;
    std::array<Strand, 1 << kSplits> waiting_strands_;
    int waiting_ = 0;
};

}  // namespace

PathResult follow_path(const Lit& lit, const Ray& ray, Sampler& sampler, std::uint64_t& rays) {
    return Follower(lit, sampler, rays).follow(ray, true);
}

glm::vec3 radiance_besides_lamp(const Lit& lit, const Ray& ray, Sampler& sampler) {
    std::uint64_t rays = 0;
    return Follower(lit, sampler, rays).follow(ray, false).radiance;
}

}  // namespace pastoso::trace
