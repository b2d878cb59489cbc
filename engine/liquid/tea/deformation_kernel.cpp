// Deforms parcels, a lane for each, in portions: looks up their cells, finds what the flow does in each
// of those once, and does it to the parcels. Compiled once per instruction set; see pastoso_add_kernels.
#include "core/lane_memory.hpp"
#include "liquid/tea/deformation_lanes.hpp"

namespace pastoso::liquid::PASTOSO_ISA {
namespace {

using Group = lanes::Widest<float>;
using GroupIndex = lanes::As<std::int32_t, Group>;
constexpr int kTogether = Group::kLanes;
/// Whole groups of any instruction set.
constexpr int kPortion = 256;
constexpr int kWordsOfStretching = 12;

/// Parcels' cells: each is listed once, or some times where sorted parcels come back to it.
struct Cells {
    std::int32_t listed[kPortion + kTogether];  ///< index of the sample before, along each axis
    int count;
    std::int32_t of_parcel[kPortion];  ///< numbers in the list
};

struct CellIndex {
    GroupIndex sample;
    GroupIndex parity;  ///< one of eight: cells around a place have each another one
};

PASTOSO_LANE_FUNCTION CellIndex cell_index(const DeformationView& view, const float* words) {
    const auto position = lanes::load_fours<Group>(
        [&](int lane) { return words + lane * kWordsOfParcel + kPositionWord; });
    const auto along = [&](int axis) {
        return lanes::clamp(lanes::convert<std::int32_t>(Group(position.row[axis] / Group(view.cell_m))),
                            GroupIndex(0), GroupIndex(view.cells[axis] - 1));
    };
    const GroupIndex x = along(0), y = along(1), z = along(2), one(1);
    return {x + y * GroupIndex(static_cast<std::int32_t>(view.stride_y)) +
                z * GroupIndex(static_cast<std::int32_t>(view.stride_z)),
            (x & one) | (y & one) << 1 | (z & one) << 2};
}

/// Of whole groups of parcels.
PASTOSO_LANE_FUNCTION void list_cells(const DeformationView& view, const ParcelWords& parcels,
                                      Cells& cells) {
    alignas(64) std::int32_t sample[kPortion], parity[kPortion];
    for (int p = 0; p < parcels.count; p += kTogether) {
        const CellIndex index = cell_index(view, parcels.words + p * kWordsOfParcel);
        lanes::store(sample + p, index.sample);
        lanes::store(parity + p, index.parity);
    }
    std::int32_t last_sample[8], last_number[8];
    for (int n = 0; n < 8; ++n)
        last_sample[n] = -1;
    cells.count = 0;
    for (int p = 0; p < parcels.count; ++p) {
        const std::int32_t of = parity[p];
        if (last_sample[of] != sample[p]) {
            last_sample[of] = sample[p];
            last_number[of] = cells.count;
            cells.listed[cells.count++] = sample[p];
        }
        cells.of_parcel[p] = last_number[of];
    }
    for (int lane = 0; lane < kTogether; ++lane)
        cells.listed[cells.count + lane] = cells.listed[0];
}

/// In the middles of a group of cells.
PASTOSO_LANE_FUNCTION Strain<Group> strain_in(const DeformationView& view, const std::int32_t* cells) {
    const std::ptrdiff_t stride[] = {1, view.stride_y, view.stride_z};
    const auto change = [&](int across, int along) __attribute__((always_inline)) {
        const auto face = [&](std::ptrdiff_t offset) __attribute__((always_inline)) {
            const float* from = view.faces[across] + offset;
            return lanes::generate<Group>([&](int lane) { return from[cells[lane]]; });
        };
        const std::ptrdiff_t next = stride[across], step = stride[along];
        const Group difference =
            along == across
                ? face(next) - face(0)
                : Group(0.25F) * (face(step) + face(step + next) - face(-step) - face(next - step));
        return Group(difference / Group(view.cell_m)) * Group(view.dt_s);
    };
    const auto row = [&](int along) {
        return Row<Group>{change(0, along), change(1, along), change(2, along)};
    };
    return {{row(0), row(1), row(2)}};
}

/// Writes what the flow does in each listed cell.
PASTOSO_LANE_FUNCTION void find_stretchings(const DeformationView& view, const Cells& cells,
                                            float* words) {
    for (int n = 0; n < cells.count; n += kTogether) {
        const Stretching<Group> of = stretching_of(strain_in(view, cells.listed + n), view.limits);
        const auto to = [&](int first) {
            return [=](int lane) { return words + (n + lane) * kWordsOfStretching + first; };
        };
        const Row<Group>&x = of.rows[0], &y = of.rows[1], &z = of.rows[2];
        lanes::store_fours<Group>({{x.x, x.y, x.z, y.x}}, to(0));
        lanes::store_fours<Group>({{y.y, y.z, z.x, z.y}}, to(4));
        lanes::store_fours<Group>({{z.z, of.widening, of.widening, of.widening}}, to(8));
    }
}

PASTOSO_LANE_FUNCTION Stretching<Group> load_stretching(const float* words, const std::int32_t* cells) {
    const auto four = [&](int first) {
        return lanes::load_fours<Group>(
            [&](int lane) { return words + cells[lane] * kWordsOfStretching + first; });
    };
    const auto a = four(0), b = four(4), c = four(8);
    return {
        {{a.row[0], a.row[1], a.row[2]}, {a.row[3], b.row[0], b.row[1]}, {b.row[2], b.row[3], c.row[0]}},
        c.row[1]};
}

PASTOSO_LANE_FUNCTION void deform_group(const Stretching<Group>& stretching, const ShapeLimits& limits,
                                        float* words) {
    const auto at = [&](int first) {
        return [=](int lane) { return words + lane * kWordsOfParcel + first; };
    };
    // The two words before the shape go along.
    const auto a = lanes::load_fours<Group>(at(kShapeWord - 2)),
               b = lanes::load_fours<Group>(at(kShapeWord + 2));
    const Covariance<Group> s =
        deformed_by(stretching, {a.row[2], a.row[3], b.row[0], b.row[1], b.row[2], b.row[3]}, limits);
    lanes::store_fours<Group>({{a.row[0], a.row[1], s.xx, s.yy}}, at(kShapeWord - 2));
    lanes::store_fours<Group>({{s.zz, s.xy, s.xz, s.yz}}, at(kShapeWord + 2));
}

/// Of whole groups of parcels.
void deform_portion(const DeformationView& view, const ParcelWords& parcels) {
    Cells cells;
    list_cells(view, parcels, cells);
    alignas(64) float stretchings[(kPortion + kTogether) * kWordsOfStretching];
    find_stretchings(view, cells, stretchings);
    for (int p = 0; p < parcels.count; p += kTogether)
        deform_group(load_stretching(stretchings, cells.of_parcel + p), view.limits,
                     parcels.words + p * kWordsOfParcel);
}

/// Of less than a group, filled up with copies of the first one.
void deform_rest(const DeformationView& view, const ParcelWords& parcels) {
    constexpr std::size_t kBytes = sizeof(float) * kWordsOfParcel;
    float group[kTogether * kWordsOfParcel];
    for (int lane = 0; lane < kTogether; ++lane)
        __builtin_memcpy(group + lane * kWordsOfParcel,
                         parcels.words + (lane < parcels.count ? lane : 0) * kWordsOfParcel, kBytes);
    deform_portion(view, {group, kTogether});
    __builtin_memcpy(parcels.words, group, kBytes * static_cast<std::size_t>(parcels.count));
}

}  // namespace

void deform(const DeformationView& view, const ParcelWords& parcels) {
    const int rest = parcels.count % kTogether, whole = parcels.count - rest;
    for (int begin = 0; begin < whole; begin += kPortion)
        deform_portion(view, {parcels.words + begin * kWordsOfParcel,
                              whole - begin < kPortion ? whole - begin : kPortion});
    if (rest > 0) deform_rest(view, {parcels.words + whole * kWordsOfParcel, rest});
}

}  // namespace pastoso::liquid::PASTOSO_ISA

PASTOSO_REGISTER_KERNELS(pastoso::liquid, DeformationKernels, deform)
