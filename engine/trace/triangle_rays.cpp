#include "trace/triangle_rays.hpp"

#include "core/check.hpp"
#include "core/error.hpp"

#include <embree3/rtcore.h>
#include <string>
#include <utility>

namespace pastoso::trace {
namespace {

static_assert(kNoTriangle == RTC_INVALID_GEOMETRY_ID);

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
        throw core::InputError("scene: there is not enough memory to trace a mesh of " +
                               std::to_string(triangles) + " triangles.");
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

}  // namespace

struct TriangleRays::State {
    State(liquid::TriangleMesh given, core::Isa isa)
        : mesh(std::move(given)), device(rtcNewDevice(configuration(isa).c_str())) {
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

    /// Embree reads the mesh where it is, four floats for each position: one more must follow the last.
    void attach_mesh() {
        const std::size_t positions = mesh.positions_m.size();
        mesh.positions_m.emplace_back(0.0F);
        const Geometry geometry(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
        check_error(device.get(), mesh.triangles.size());
        rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                   mesh.positions_m.data(), 0, sizeof(glm::vec3), positions);
        rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                   mesh.triangles.data(), 0, sizeof(mesh.triangles[0]),
                                   mesh.triangles.size());
        rtcCommitGeometry(geometry.get());
        rtcAttachGeometry(scene.get(), geometry.get());
        check_error(device.get(), mesh.triangles.size());
    }

    liquid::TriangleMesh mesh;
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
    if (empty()) return {ray.farthest, 0.0F, 0.0F, kNoTriangle};
    RTCRayHit query;
    query.ray = embree_ray(ray);
    query.hit.geomID = query.hit.primID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    query.hit.u = query.hit.v = 0.0F;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(state_->scene.get(), &context, &query);
    return {query.ray.tfar, query.hit.u, query.hit.v, query.hit.primID};
}

bool TriangleRays::anything_between(const MeshRay& ray) const {
    if (empty()) return false;
    RTCRay query = embree_ray(ray);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(state_->scene.get(), &context, &query);
    return query.tfar < 0.0F;
}

}  // namespace pastoso::trace
