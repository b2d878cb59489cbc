#include "trace/triangle_rays.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "trace/sheared_ray.hpp"

#include <algorithm>
#include <embree3/rtcore.h>
#include <limits>
#include <string>
#include <utility>

#include <glm/common.hpp>

namespace pastoso::trace {
namespace {

template <auto release>
struct Release {
    template <class Object>
    void operator()(Object* object) const {
        release(object);
    }
};
using Device = std::unique_ptr<RTCDeviceTy, Release<rtcReleaseDevice>>;
using Geometry = std::unique_ptr<RTCGeometryTy, Release<rtcReleaseGeometry>>;
using EmbreeScene = std::unique_ptr<RTCSceneTy, Release<rtcReleaseScene>>;

/// No threads besides the caller's: those would be kept, and look for work where a painting needs the
/// processor. No instruction set beyond ours, so that PASTOSO_ISA narrows Embree as well.
std::string configuration(core::Isa isa) {
    const std::string alone = "threads=1,user_threads=1,set_affinity=0";
#if defined(__x86_64__)
    if (isa == core::Isa::Baseline) return alone + ",max_isa=sse4.2";
    if (isa == core::Isa::Avx2) return alone + ",max_isa=avx2";
#endif
    return alone;
}

/// Too many triangles for the memory are bad input; all else that Embree objects to is a mistake of
/// ours.
void check_error(RTCDevice device, std::size_t triangles) {
    const RTCError error = rtcGetDeviceError(device);
    if (error == RTC_ERROR_OUT_OF_MEMORY)
        throw core::InputError("scene: there is not enough memory to trace a mesh of %1 triangles.",
                               triangles);
    PASTOSO_CHECK_OP(error, ==, RTC_ERROR_NONE);
}

RTCRay embree_ray(const MeshRay& ray) {
    RTCRay out;
    out.org_x = ray.origin.x, out.org_y = ray.origin.y, out.org_z = ray.origin.z;
    out.dir_x = ray.direction.x, out.dir_y = ray.direction.y, out.dir_z = ray.direction.z;
    out.tnear = ray.nearest, out.tfar = ray.farthest;
    out.time = 0.0F;
    out.mask = 0xFFFFFFFFU;
    out.id = out.flags = 0;
    return out;
}

/// By how much of the mesh's farthest coordinate the boxes around triangles are too wide: the ray meets
/// a triangle's box before the triangle, however the two are rounded.
constexpr float kMargin = 1e-6F;

float farthest_coordinate(const liquid::TriangleMesh& mesh) {
    glm::vec3 farthest(0.0F);
    for (const glm::vec3& position : mesh.positions_m)
        farthest = glm::max(farthest, glm::abs(position));
    return std::max({farthest.x, farthest.y, farthest.z});
}

/// What the callbacks need of a ray. Embree hands its context on to them, of which this is one.
struct Query : RTCIntersectContext {
    explicit Query(const MeshRay& ray)
        : nearest(ray.nearest), sheared(ray), hit{ray.farthest, 0.0F, 0.0F, kNoTriangle} {
        rtcInitIntersectContext(this);
    }
    float nearest;
    ShearedRay sheared;
    MeshHit hit;  ///< the nearest so far; of equally near ones that of the lowest number
};

}  // namespace

struct TriangleRays::State {
    State(liquid::TriangleMesh given, core::Isa isa)
        : mesh(std::move(given)),
          margin(kMargin * farthest_coordinate(mesh)),
          device(rtcNewDevice(configuration(isa).c_str())) {
        check_error(device.get(), mesh.triangles.size());
        scene.reset(rtcNewScene(device.get()));
        check_error(device.get(), mesh.triangles.size());
        rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
        // The low quality builds four times as fast, but a picture asks for millions of rays, which then
        // take a tenth longer; the high one finds nothing to split in meshes of small triangles.
        rtcSetSceneBuildQuality(scene.get(), RTC_BUILD_QUALITY_MEDIUM);
        attach_mesh();
        // rtcCommitScene() starts a thread even where one is all that it may use; joining starts none.
        rtcJoinCommitScene(scene.get());
        check_error(device.get(), mesh.triangles.size());
    }

    void attach_mesh() {
        const Geometry geometry(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_USER));
        check_error(device.get(), mesh.triangles.size());
        rtcSetGeometryUserPrimitiveCount(geometry.get(), static_cast<unsigned>(mesh.triangles.size()));
        rtcSetGeometryUserData(geometry.get(), this);
        rtcSetGeometryBoundsFunction(geometry.get(), &bound, nullptr);
        rtcSetGeometryIntersectFunction(geometry.get(), &intersect);
        rtcSetGeometryOccludedFunction(geometry.get(), &occlude);
        rtcCommitGeometry(geometry.get());
        rtcAttachGeometry(scene.get(), geometry.get());
        check_error(device.get(), mesh.triangles.size());
    }

    static void bound(const RTCBoundsFunctionArguments* asked) {
        const auto& state = *static_cast<const State*>(asked->geometryUserPtr);
        const auto& [a, b, c] = state.mesh.triangles[asked->primID];
        const glm::vec3 &pa = state.mesh.positions_m[a], &pb = state.mesh.positions_m[b],
                        &pc = state.mesh.positions_m[c];
        const glm::vec3 low = glm::min(pa, glm::min(pb, pc)) - state.margin,
                        high = glm::max(pa, glm::max(pb, pc)) + state.margin;
        *asked->bounds_o = {low.x, low.y, low.z, 0.0F, high.x, high.y, high.z, 0.0F};
    }

    /// Takes the triangle for the query's nearest where it is that.
    bool meet(std::uint32_t triangle, Query& query) const {
        const auto& [a, b, c] = mesh.triangles[triangle];
        MeshHit met{0.0F, 0.0F, 0.0F, triangle};
        if (!query.sheared.meets(mesh.positions_m[a], mesh.positions_m[b], mesh.positions_m[c], met))
            return false;
        const bool counts = met.distance > query.nearest &&
                            (met.distance < query.hit.distance ||
                             (met.distance == query.hit.distance && triangle < query.hit.triangle));
        if (counts) query.hit = met;
        return counts;
    }

    // Embree asks with one ray each time, and for a box that it has met.

    static void intersect(const RTCIntersectFunctionNArguments* asked) {
        const auto& state = *static_cast<const State*>(asked->geometryUserPtr);
        auto& query = *static_cast<Query*>(asked->context);
        auto& found = *reinterpret_cast<RTCRayHit*>(asked->rayhit);
        if (state.meet(asked->primID, query)) found.ray.tfar = query.hit.distance;
    }

    static void occlude(const RTCOccludedFunctionNArguments* asked) {
        const auto& state = *static_cast<const State*>(asked->geometryUserPtr);
        auto& query = *static_cast<Query*>(asked->context);
        auto& ray = *reinterpret_cast<RTCRay*>(asked->ray);
        if (state.meet(asked->primID, query)) ray.tfar = -std::numeric_limits<float>::infinity();
    }

    liquid::TriangleMesh mesh;
    float margin;
    Device device;
    EmbreeScene scene;
};

TriangleRays::TriangleRays() = default;
TriangleRays::TriangleRays(liquid::TriangleMesh mesh, core::Isa isa)
    : state_(mesh.empty() ? nullptr : std::make_unique<State>(std::move(mesh), isa)) {}
TriangleRays::~TriangleRays() = default;
TriangleRays::TriangleRays(TriangleRays&&) noexcept = default;
TriangleRays& TriangleRays::operator=(TriangleRays&&) noexcept = default;

const liquid::TriangleMesh& TriangleRays::mesh() const {
    PASTOSO_CHECK(!empty());
    return state_->mesh;
}

MeshHit TriangleRays::closest(const MeshRay& ray) const {
    Query query(ray);
    if (empty()) return query.hit;
    RTCRayHit found;
    found.ray = embree_ray(ray);
    found.hit.geomID = found.hit.primID = RTC_INVALID_GEOMETRY_ID;
    found.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    found.hit.u = found.hit.v = 0.0F;
    rtcIntersect1(state_->scene.get(), &query, &found);
    return query.hit;
}

bool TriangleRays::anything_between(const MeshRay& ray) const {
    if (empty()) return false;
    Query query(ray);
    RTCRay found = embree_ray(ray);
    rtcOccluded1(state_->scene.get(), &query, &found);
    return query.hit.triangle != kNoTriangle;
}

}  // namespace pastoso::trace
