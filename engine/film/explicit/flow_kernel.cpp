// Compiled once per instruction set; see pastoso_add_kernels.
#include "film/explicit/face_step.hpp"
#include "film/explicit/tile_kernels.hpp"
#include "film/face/face_loading.hpp"

#include <algorithm>

namespace pastoso::film::PASTOSO_ISA {
namespace {

using grid::kTileSize;

using Ints = lanes::As<std::int32_t, Lanes>;

/// Thickness quanta carried in a step: |velocity| thickness dt / cell, rounded half away from zero, at
/// most a quarter of the cell that they leave.
[[gnu::always_inline]] inline Ints flux_quanta(const FaceFlow<Lanes>& flow, const StepConstants& step,
                                               const Ints& quanta_left, const Ints& quanta_right) {
    const Lanes scale(step.dt_s * step.inverse_cell * static_cast<float>(1.0 / kThicknessQuantum_mm));
    const Lanes exact = flow.velocity * flow.thickness * scale;
    const Ints wanted = lanes::convert<std::int32_t>(Lanes(exact + lanes::copysign(Lanes(0.5F), exact)));
    return lanes::max(lanes::min(wanted, Ints(quanta_left >> 2)), Ints(-(quanta_right >> 2)));
}

/// The largest values met so far, lane by lane.
struct LaneExtremes {
    Lanes mobility{0.0F}, thickness{0.0F}, speed{0.0F};
    Ints cell_quanta{0};

    /// `counts` is 1, or 0 in lanes beyond the canvas.
    [[gnu::always_inline]] void add(const FaceFlow<Lanes>& flow, Lanes counts) {
        const Lanes velocity = counts * flow.velocity;
        mobility = lanes::max(mobility, Lanes(counts * flow.mobility));
        speed = lanes::max(speed, lanes::abs(velocity));
        thickness =
            lanes::max(thickness, lanes::select(velocity == Lanes(0.0F), Lanes(0.0F), flow.thickness));
    }
    [[gnu::always_inline]] void add_cells(const Ints& left, const Ints& right) {
        cell_quanta = lanes::max(cell_quanta, lanes::max(left, right));
    }
    /// Whether a cell may be too full for a quarter of another: where none holds more than half of what
    /// it may, a quarter of one never exceeds a quarter of the other's capacity left.
    bool any_full() const { return lanes::largest(cell_quanta) > kMaxThickness_quanta / 2; }
    FlowExtremes reduced() const {
        return {.mobility = lanes::largest(mobility),
                .thickness_mm = lanes::largest(thickness),
                .speed_mm_s = lanes::largest(speed),
                .seen_speed_mm_s = lanes::largest(speed)};
    }
};

/// 1 for the first cells of a line, which lie on the canvas, and 0 for the others.
using LineMask = std::array<float, kTileSize>;
LineMask line_mask(int cells_on_canvas) {
    LineMask mask{};
    std::fill_n(mask.data(), cells_on_canvas, 1.0F);
    return mask;
}

/// Faces of one axis of a tile: where they come from and where their flow goes.
template <FaceModel kModel>
struct FaceKernel {
    const TileScratch& scratch;
    const StepConstants& step;
    Axis axis;
    FaceArray<float>& velocity;
    FaceArray<std::int32_t>& flux;

    template <FacePlace kPlace>
    [[gnu::always_inline]] void drive_at(int i, const StepConstants& constants,
                                         FaceDrive<kModel, Lanes>& drive) const {
        explicit_drive<kModel, kPlace>(
            neighbourhood<kModel, kPlace>(scratch, constants, axis, AlongRow{}, i), constants,
            axis.force, axis.force_across, drive);
    }
    /// Not inlined: what it keeps in registers would slow down the faces in the middle of the film.
    [[gnu::noinline]] void drive_near_end(int i, FaceDrive<kModel, Lanes>& drive) const {
        drive_at<FacePlace::Anywhere>(i, step, drive);
    }

    /// Faces 0..63 of a row, in a loop for each stage: the chain of dependent divisions through all of
    /// them is too long for the processor to overlap whole faces.
    void flow_row(int y, const LineMask& on_canvas, LaneExtremes& extremes) const {
        constexpr int kGroups = kTileSize / kLanes;
        const StepConstants local = step;  // which no store through a pointer can change
        LaneExtremes found = extremes;     // likewise
        std::array<FaceDrive<kModel, Lanes>, kGroups> drive;
        std::array<FaceDrag<Lanes>, kGroups> drag;
        std::array<BinghamDrag<Lanes>, kGroups> law;
        for (int group = 0; group < kGroups; ++group) {
            const int i = block_index(group * kLanes, y);
            if (are_in_film<kModel>(scratch, local, axis, i))
                drive_at<FacePlace::InFilm>(i, local, drive[group]);
            else
                drive_near_end(i, drive[group]);
        }
        for (int group = 0; group < kGroups; ++group)
            drag[group] = face_drag<kModel>(drive[group], local);
        for (int group = 0; group < kGroups; ++group)
            law[group] = drag_law<kModel.yield>(drag[group].drag, drag[group].stress);
        const std::int32_t* quanta = &scratch.block.quanta[block_index(0, y)];
        for (int group = 0; group < kGroups; ++group) {
            const int x = group * kLanes;
            const FaceFlow<Lanes> flow =
                face_flow(drive[group].thickness, drag[group], law[group], local);
            found.add(flow, load(&on_canvas[x]));
            const Ints left = lanes::load<Ints>(quanta + x);
            const Ints right = lanes::load<Ints>(quanta + x + axis.along);
            found.add_cells(left, right);
            store(&velocity[face_index(x, y)], flow.velocity);
            lanes::store(&flux[face_index(x, y)], flux_quanta(flow, local, left, right));
        }
        extremes = found;
    }

    /// Faces 0..63 of a column.
    void flow_column(int x, const LineMask& on_canvas, LaneExtremes& extremes) const {
        const std::int32_t* quanta = scratch.block.quanta.data();
        for (int y = 0; y < kTileSize; y += kLanes) {
            const int i = block_index(x, y);
            const FaceFlow<Lanes> flow = face_flow<kModel>(
                neighbourhood<kModel, FacePlace::Anywhere>(scratch, step, axis, AlongColumn{}, i), step,
                axis.force, axis.force_across);
            extremes.add(flow, load(&on_canvas[y]));
            const Ints left =
                lanes::generate<Ints>([&](int lane) { return quanta[i + lane * kBlockStride]; });
            const Ints right = lanes::generate<Ints>(
                [&](int lane) { return quanta[i + axis.along + lane * kBlockStride]; });
            extremes.add_cells(left, right);
            const Ints quanta_through = flux_quanta(flow, step, left, right);
            for (int lane = 0; lane < kLanes; ++lane) {
                velocity[face_index(x, y + lane)] = flow.velocity[lane];
                flux[face_index(x, y + lane)] = quanta_through[lane];
            }
        }
    }

    void clear_row(int y) const {
        std::fill_n(&velocity[face_index(0, y)], kTileSize, 0.0F);
        std::fill_n(&flux[face_index(0, y)], kTileSize, 0);
    }
};
static_assert(kTileSize % kLanes == 0);

/// Shuts closed edges and everything beyond the canvas.
void shut_closed_faces(int columns, int rows, const ClosedFaces& closed, TileScratch& scratch) {
    for_each_shut_face(
        columns, rows, closed, scratch.block,
        [&](int f) {
            scratch.velocity_x[f] = 0.0F;
            scratch.flux_x[f] = 0;
        },
        [&](int f) {
            scratch.velocity_y[f] = 0.0F;
            scratch.flux_y[f] = 0;
        });
}

int count_clamped(const StepConstants& step, const FaceArray<float>& velocity, int first_x,
                  int first_y) {
    const float limit = 0.5F * step.cell_mm / step.dt_s;
    int count = 0;
    for (int y = first_y; y < kTileSize; ++y)
        for (int x = first_x; x < kTileSize; ++x)
            count += lanes::abs(velocity[face_index(x, y)]) >= limit ? 1 : 0;
    return count;
}

/// Cuts the fluxes of one axis to a quarter of the capacity left in the cell behind the face, so that
/// four cannot overfill it. Returns how many that were.
int cut_to_capacity(const HaloBlock& block, int along, int first_x, int first_y,
                    FaceArray<float>& velocity, FaceArray<std::int32_t>& flux) {
    const auto quarter_capacity = [](std::int32_t quanta) {
        return quanta < kMaxThickness_quanta ? (kMaxThickness_quanta - quanta) >> 2 : 0;
    };
    int count = 0;
    for (int y = first_y; y < kTileSize; ++y)
        for (int x = first_x; x < kTileSize; ++x) {
            const int f = face_index(x, y), i = block_index(x, y);
            const std::int32_t wanted = flux[f];
            const std::int32_t forwards = quarter_capacity(block.quanta[i + along]);
            const std::int32_t backwards = -quarter_capacity(block.quanta[i]);
            const std::int32_t passing = wanted > forwards    ? forwards
                                         : wanted < backwards ? backwards
                                                              : wanted;
            if (passing == wanted) continue;
            velocity[f] *= static_cast<float>(passing) / static_cast<float>(wanted);
            flux[f] = passing;
            ++count;
        }
    return count;
}

int cut_to_capacity(TileScratch& scratch) {
    return cut_to_capacity(scratch.block, 1, -1, 0, scratch.velocity_x, scratch.flux_x) +
           cut_to_capacity(scratch.block, kBlockStride, 0, -1, scratch.velocity_y, scratch.flux_y);
}

template <FaceModel kModel>
LaneExtremes flow_all_faces(const StepConstants& step, int columns, int rows, TileScratch& scratch) {
    using Kernel = FaceKernel<kModel>;
    const HaloBlock& block = scratch.block;
    const float* u = block.velocity_x.data();
    const float* v = block.velocity_y.data();
    const float force_x = step.force_x_mm_s2, force_y = step.force_y_mm_s2;
    const Kernel x_faces{
        scratch, step, {1, kBlockStride, u, v, force_x, force_y}, scratch.velocity_x, scratch.flux_x};
    const Kernel y_faces{
        scratch, step, {kBlockStride, 1, v, u, force_y, force_x}, scratch.velocity_y, scratch.flux_y};
    const int first = block.first_wet_row, last = std::min(block.last_wet_row, rows - 1);
    const LineMask on_canvas = line_mask(columns);
    LaneExtremes extremes;
    for (int y = -1; y < kTileSize; ++y) {
        if (y >= first - 1 && y <= last)
            y_faces.flow_row(y, on_canvas, extremes);
        else
            y_faces.clear_row(y);
        if (y < 0) continue;
        if (y >= first && y <= last)
            x_faces.flow_row(y, on_canvas, extremes);
        else
            x_faces.clear_row(y);
    }
    x_faces.flow_column(-1, line_mask(rows), extremes);
    return extremes;
}

}  // namespace

FlowExtremes tile_flow(const StepConstants& step, int columns, int rows, const ClosedFaces& closed,
                       TileScratch& scratch) {
    if (scratch.block.last_wet_row >= scratch.block.first_wet_row) prepare_pressure(step, scratch);
    const LaneExtremes found = with_face_model(
        step, [&]<FaceModel kModel>() { return flow_all_faces<kModel>(step, columns, rows, scratch); });
    shut_closed_faces(columns, rows, closed, scratch);
    FlowExtremes extremes = found.reduced();
    if (extremes.speed_mm_s >= 0.5F * step.cell_mm / step.dt_s)
        extremes.clamped_faces = count_clamped(step, scratch.velocity_x, -1, 0) +
                                 count_clamped(step, scratch.velocity_y, 0, -1);
    if (found.any_full()) extremes.clamped_faces += cut_to_capacity(scratch);
    return extremes;
}

}  // namespace pastoso::film::PASTOSO_ISA
