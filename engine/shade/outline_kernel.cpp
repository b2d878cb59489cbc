#include "shade/outline.hpp"
#include "shade/row_blending.hpp"

#include <algorithm>

namespace pastoso::shade::PASTOSO_ISA {
namespace {

/// Samples of a row, as they are seen without an outline and on its two sides; null for what is not
/// seen.
struct Points {
    const PointGroup* plain = nullptr;
    const PointGroup* paint = nullptr;
    PointGroup* dry = nullptr;
    const float* within = nullptr;     ///< how much of a sample shows paint
    const float* strength = nullptr;   ///< how much of the outline is drawn
    const float* height_mm = nullptr;  ///< with the paint and its foot
    const float* rim_mm = nullptr;     ///< how much higher the dry side receives shadows
};

/// The layers of the outline, between the rows.
struct OutlineLines {
    alignas(64) float cover[kMaxRowCells], slope[kMaxRowCells];
    alignas(64) float share[kMaxRowCells];  ///< as colours are blended
    alignas(64) float smooth_share[kMaxRowCells], smooth_sharp[kMaxRowCells];  ///< as heights are
    ColourLine covered, dry;
    ReliefLine support;
};

/// Calls use(first, count, near) for stretches of samples that lie near an outline, or do not.
template <class Use>
void for_each_stretch(const std::uint8_t* near, const SampleColumns& columns, const Use& use) {
    for (int first = 0, end = 0; first < columns.count; first = end) {
        const bool is_near = near[columns.first_cell[first]] != 0;
        end = first + 1;
        while (end < columns.count && end - first < kGroup &&
               (near[columns.first_cell[end]] != 0) == is_near)
            ++end;
        use(first, end - first, is_near);
    }
}

enum class Seen { Dry, Paint, Both };

Seen seen_at(float within) {
    return within <= 0.0F ? Seen::Dry : within >= 1.0F ? Seen::Paint : Seen::Both;
}

/// Calls use(first, count, seen) for the parts of a stretch that show one side, or both.
template <class Use>
void for_each_part(const float* within, int count, const Use& use) {
    for (int first = 0, end = 0; first < count; first = end) {
        const Seen seen = seen_at(within[first]);
        end = first + 1;
        while (end < count && seen_at(within[end]) == seen)
            ++end;
        use(first, end - first, seen);
    }
}

/// How an outline cuts samples, as Points have it.
struct Cut {
    alignas(64) float within[kGroup], strength[kGroup], rim_mm[kGroup];
};

void cut(const OutlineLines& lines, int begin, const SampleColumns& columns, int first, int count,
         const OutlineSampling& sampling, Cut& __restrict result) {
    const float width_cells = sampling.width_cells, most = sampling.strength;
    const float cell_mm = sampling.cell_mm;
    for (int i = 0; i < count; ++i) {
        const int cell = columns.first_cell[first + i] - begin;
        const float cover = blend(lines.cover + cell, columns.spline, first + i);
        result.within[i] =
            share_within(cover, blend(lines.cover + cell, columns.slope, first + i),
                         blend(lines.slope + cell, columns.spline, first + i), width_cells);
        result.rim_mm[i] = cell_mm * rim_cells(cover);
        result.strength[i] =
            most * sharpness(blend(lines.smooth_share + cell, columns.spline, first + i),
                             blend(lines.smooth_sharp + cell, columns.spline, first + i));
    }
}

/// The paint's colour is the mean of what the cells around show, weighed by how much of them it covers.
void weigh(const OutlineLines& lines, int begin, const SampleColumns& columns, int first, int count,
           PointGroup& __restrict paint) {
    constexpr float kLeastShare = 1e-3F;
    for (int i = 0; i < count; ++i) {
        const int cell = columns.first_cell[first + i] - begin;
        const float share = blend(lines.share + cell, columns.colour, first + i);
        const float inverse = 1.0F / (share > kLeastShare ? share : kLeastShare);
        paint.red[i] *= inverse;
        paint.green[i] *= inverse;
        paint.blue[i] *= inverse;
        paint.wetness[i] *= inverse;
    }
}

/// One row of samples with outlines.
class OutlinedRow {
  public:
    OutlinedRow(const LayerRows& rows, const OutlineRows& outline, const AxisWeights& weights,
                const SampleColumns& columns, const OutlineSampling& sampling)
        : lines_(rows, weights, columns), rows_(outline), weights_(weights), sampling_(sampling) {}

    /// Calls use(points, first, count) for all samples.
    template <class Use>
    void visit(const Use& use) {
        for_each_stretch(rows_.near, lines_.columns, [&](int first, int count, bool near) {
            if (near) return visit_stretch(first, count, use);
            Points points;
            points.plain = &plain_;
            lines_.place(first, count, plain_);
            use(points, first, count);
        });
    }

  private:
    template <class Use>
    void visit_stretch(int first, int count, const Use& use) {
        blend_outline(lines_.columns.first_cell[first],
                      lines_.columns.first_cell[first + count - 1] + 4);
        cut(outline_, lines_.begin, lines_.columns, first, count, sampling_, cut_);
        for_each_part(cut_.within, count, [&](int part, int size, Seen seen) {
            Points points = place(first + part, size, seen);
            if (*std::min_element(cut_.strength + part, cut_.strength + part + size) < 1.0F) {
                lines_.place(first + part, size, plain_);
                points.plain = &plain_;
            }
            points.within = cut_.within + part;
            points.strength = cut_.strength + part;
            points.rim_mm = cut_.rim_mm + part;
            use(points, first + part, size);
        });
    }

    void blend_outline(int from, int to) {
        const int begin = lines_.begin;
        for (int x = from; x < to; ++x) {
            outline_.cover[x - begin] = blend(rows_.cover, weights_.spline, x);
            outline_.slope[x - begin] = blend(rows_.cover, weights_.slope, x);
            outline_.share[x - begin] = blend(rows_.share, weights_.colour, x);
            outline_.smooth_share[x - begin] = blend(rows_.share, weights_.spline, x);
            outline_.smooth_sharp[x - begin] = blend(rows_.sharp, weights_.spline, x);
        }
        blend_colours(rows_.covered, weights_, begin, from, to, outline_.covered);
        blend_colours(rows_.dry, weights_, begin, from, to, outline_.dry);
        blend_relief(rows_.support, weights_, begin, from, to, outline_.support);
    }

    Points place(int first, int count, Seen seen) {
        Points points;
        place_light(lines_.light, lines_.begin, lines_.columns, first, count, paint_);
        if (seen == Seen::Dry)
            place_height(lines_.relief, lines_.begin, lines_.columns, first, count, paint_);
        else
            place_relief(lines_.relief, lines_.begin, lines_.columns, first, count, paint_);
        points.height_mm = paint_.height_mm;
        if (seen != Seen::Dry) {
            place_colours(outline_.covered, lines_.begin, lines_.columns, first, count, paint_);
            weigh(outline_, lines_.begin, lines_.columns, first, count, paint_);
            points.paint = &paint_;
        }
        if (seen != Seen::Paint) {
            place_relief(outline_.support, lines_.begin, lines_.columns, first, count, dry_);
            std::copy_n(paint_.shadow_mm, count, dry_.shadow_mm);
            std::copy_n(paint_.sky, count, dry_.sky);
            place_colours(outline_.dry, lines_.begin, lines_.columns, first, count, dry_);
            points.dry = &dry_;
        }
        return points;
    }

    RowLines lines_;
    const OutlineRows& rows_;
    const AxisWeights& weights_;
    OutlineSampling sampling_;
    OutlineLines outline_;
    PointGroup plain_, paint_, dry_;
    Cut cut_;
};

/// What is seen where `within` of a sample shows paint, and `strength` of the outline is drawn.
float mixed(const float* plain, const float* paint, const float* dry, float within, float strength) {
    const float outlined = dry == nullptr     ? *paint
                           : paint == nullptr ? *dry
                                              : (1.0F - within) * *dry + within * *paint;
    return plain == nullptr ? outlined : (1.0F - strength) * *plain + strength * outlined;
}

}  // namespace

void outline_row(const LayerRows& rows, const OutlineRows& outline, const AxisWeights& row_weights,
                 const SampleColumns& columns, const OutlineSampling& sampling,
                 const ShadingConstants& light, float* rgb) {
    const float cells_per_mm = 1.0F / sampling.cell_mm;
    float plain[3 * kGroup], paint[3 * kGroup], dry[3 * kGroup];
    OutlinedRow(rows, outline, row_weights, columns, sampling)
        .visit([&](const Points& points, int first, int count) {
            if (points.within == nullptr)
                return shade_points(*points.plain, count, cells_per_mm, light, rgb + 3 * first);
            if (points.plain != nullptr) shade_points(*points.plain, count, cells_per_mm, light, plain);
            if (points.paint != nullptr) shade_points(*points.paint, count, cells_per_mm, light, paint);
            if (points.dry != nullptr) {
                // What throws a shadow has been told with the paint's foot, and so is what receives it.
                for (int i = 0; i < count; ++i)
                    points.dry->height_mm[i] = points.height_mm[i] + points.rim_mm[i];
                shade_points(*points.dry, count, cells_per_mm, light, dry);
            }
            for (int i = 0; i < 3 * count; ++i)
                rgb[3 * first + i] = mixed(points.plain == nullptr ? nullptr : plain + i,
                                           points.paint == nullptr ? nullptr : paint + i,
                                           points.dry == nullptr ? nullptr : dry + i,
                                           points.within[i / 3], points.strength[i / 3]);
        });
}

void outline_samples(const LayerRows& rows, const OutlineRows& outline, const AxisWeights& row_weights,
                     const SampleColumns& columns, const OutlineSampling& sampling, SurfaceSample* out) {
    const float cells_per_mm = 1.0F / sampling.cell_mm;
    SurfaceSample plain[kGroup], paint[kGroup], dry[kGroup];
    OutlinedRow(rows, outline, row_weights, columns, sampling)
        .visit([&](const Points& points, int first, int count) {
            if (points.within == nullptr)
                return store_points(*points.plain, count, cells_per_mm, out + first);
            if (points.plain != nullptr) store_points(*points.plain, count, cells_per_mm, plain);
            if (points.paint != nullptr) store_points(*points.paint, count, cells_per_mm, paint);
            if (points.dry != nullptr) store_points(*points.dry, count, cells_per_mm, dry);
            for (int i = 0; i < count; ++i)
                for (float SurfaceSample::*value :
                     {&SurfaceSample::red, &SurfaceSample::green, &SurfaceSample::blue,
                      &SurfaceSample::wetness, &SurfaceSample::height_mm, &SurfaceSample::slope_x,
                      &SurfaceSample::slope_y})
                    out[first + i].*value = mixed(points.plain == nullptr ? nullptr : &(plain[i].*value),
                                                  points.paint == nullptr ? nullptr : &(paint[i].*value),
                                                  points.dry == nullptr ? nullptr : &(dry[i].*value),
                                                  points.within[i], points.strength[i]);
        });
}

}  // namespace pastoso::shade::PASTOSO_ISA
