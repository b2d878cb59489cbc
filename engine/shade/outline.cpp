#include "shade/outline.hpp"

#include "shade/cell_span.hpp"
#include "shade/surface.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace pastoso::shade {
namespace {

using grid::Rect;

/// Cells around one whose thickness tells the share that is covered, and whose shares tell its cover.
constexpr int kShareReach = 2;
constexpr int kGainReach = 3;

/// Cells beyond the first that a sample's splines take in.
constexpr int kBlock = 3;

/// The share of a cell that wet paint covers, 0 to 1, told by thickness alone: that of the cell, h > 0,
/// the least and the most of the nine cells around and with it, and the most of 25; in any one unit.
///
///     r = h / most,    b = min(1, 2 (1 - most / farther)),    c = min(1, r + b sqrt(r^2 + r))
///
/// A cliff stands as high in the next cells as in those behind, b = 0, and the covered share is r. A
/// film that ends in a slope has a mean of w^2 / 2 where it covers w of the cell, and of w + 1/2 in the
/// next: r = w^2 / (2 w + 1), so that w = r + sqrt(r^2 + r), b = 1. Rounded rims lie between. Paint goes
/// on beyond the cell, and covers all of it, where the least is a sixteenth of h or more.
float wet_share(float h, float least, float most, float farther) {
    const float ratio = h / most;
    const float sloping = std::min(1.0F, 2.0F - 2.0F * (most / farther));
    const float covered = std::min(1.0F, ratio + sloping * std::sqrt(ratio * ratio + ratio));
    const float ending = std::max(0.0F, 1.0F - 16.0F * (least / h));
    return 1.0F - ending * (1.0F - covered);
}

/// What the share of a cell is multiplied by, so that what is no wider than a cell is drawn about as
/// large as it is. `most` is the most that the spline through the shares has in the middles of the nine
/// cells around: 1 or little less at the edge of a wide film (gain 1), 0.67 on a line of one cell
/// (1.04), and 0.44 on a single cell (1.8), which would not reach 1/2 anywhere.
float lone_gain(float most) {
    return 0.5F / std::clamp(0.9F * most - 0.12F, 0.28F, 0.5F);
}

std::size_t count_of(const Rect& cells) {
    return static_cast<std::size_t>(cells.width()) * cells.height();
}

/// The thinnest and the thickest of the cells around those of a row.
struct Around {
    explicit Around(int width) : least(width), most(width), farther(width) {}

    std::vector<float> least, most, farther;
};

/// `row` is the first thickness of the rows' margin, two above and two left of the first cell.
void look_around(const float* row, std::ptrdiff_t stride, int width, Around& around) {
    const float* own = row + kShareReach * stride + kShareReach;
    for (std::vector<float>* values : {&around.least, &around.most, &around.farther})
        std::copy_n(own, width, values->data());
    for (int j = 0; j <= 2 * kShareReach; ++j, row += stride) {
        const bool next = std::abs(j - kShareReach) <= 1;
        for (int x = 0; x < width; ++x) {
            const float middle = std::max(row[x + 1], std::max(row[x + 2], row[x + 3]));
            const float all = std::max(middle, std::max(row[x], row[x + 4]));
            around.farther[x] = std::max(around.farther[x], all);
            if (!next) continue;
            around.most[x] = std::max(around.most[x], middle);
            around.least[x] =
                std::min(around.least[x], std::min(row[x + 1], std::min(row[x + 2], row[x + 3])));
        }
    }
}

void put_shares(const film::FilmState& film, const Rect& cells, float* out) {
    const Rect margin = grown(cells, kShareReach);
    std::vector<float> thickness(count_of(margin));
    thickness_means(film, margin, thickness.data(), margin.width());
    Around around(cells.width());
    for (int y = 0; y < cells.height(); ++y, out += cells.width()) {
        const float* row = thickness.data() + static_cast<std::ptrdiff_t>(y) * margin.width();
        const float* own = row + static_cast<std::ptrdiff_t>(kShareReach) * margin.width() + kShareReach;
        look_around(row, margin.width(), cells.width(), around);
        for (int x = 0; x < cells.width(); ++x)
            out[x] = own[x] > 0.0F
                         ? wet_share(own[x], around.least[x], around.most[x], around.farther[x])
                         : 0.0F;
    }
}

/// The mean over nine cells with the weights 1, `middle`, 1 along both axes.
float mean_of_nine(const float* own, std::ptrdiff_t stride, float middle) {
    const auto row = [middle](const float* at) { return at[-1] + at[1] + middle * at[0]; };
    const float sum = row(own - stride) + row(own + stride) + middle * row(own);
    return sum / ((middle + 2.0F) * (middle + 2.0F));
}

/// What the spline through the shares has in the middles of all cells but those of the margin.
std::vector<float> spline_of(const std::vector<float>& share, const Rect& cells) {
    std::vector<float> spline(share.size());
    const std::ptrdiff_t stride = cells.width();
    for (int y = 1; y < cells.height() - 1; ++y)
        for (std::ptrdiff_t i = y * stride + 1; i < (y + 1) * stride - 1; ++i)
            spline[i] = mean_of_nine(share.data() + i, stride, 4.0F);
    return spline;
}

/// The most of (2 reach + 1)^2 values.
float most_around(const float* middle, std::ptrdiff_t stride, int reach) {
    float most = 0.0F;
    for (int j = -reach; j <= reach; ++j)
        for (int i = -reach; i <= reach; ++i)
            most = std::max(most, middle[j * stride + i]);
    return most;
}

/// What the outline is told from, given the share of a cell and the spline through those around it. The
/// edges of what is wider than two cells are smoothed by one more mean, over 1, 2, 1: rims vary from
/// cell to cell.
float cover_of(const float* share, const float* spline, std::ptrdiff_t stride) {
    const float lone = *share * lone_gain(most_around(spline, stride, 1));
    const float wide = 5.0F * std::clamp(most_around(spline, stride, 2) - 0.8F, 0.0F, 0.2F);
    return lone + wide * (mean_of_nine(share, stride, 2.0F) - lone) - 0.5F;
}

/// Shares, coefficients and paint's own relief of a rectangle of cells.
struct Fields {
    explicit Fields(const Rect& cells) : share(count_of(cells)), cover(share), paint_mm(share) {}

    std::vector<float> share, cover, paint_mm;
};

/// `cells` lie on the canvas.
Fields fields_on(const film::FilmState& film, const Rect& cells) {
    const Rect margin = grown(cells, kGainReach);
    std::vector<float> share(count_of(margin));
    put_shares(film, margin, share.data());
    const std::vector<float> spline = spline_of(share, margin);
    Fields fields(cells);
    std::size_t to = 0;
    for (int y = 0; y < cells.height(); ++y) {
        std::ptrdiff_t from = static_cast<std::ptrdiff_t>(y + kGainReach) * margin.width() + kGainReach;
        for (int x = 0; x < cells.width(); ++x, ++to, ++from) {
            fields.share[to] = share[from];
            fields.cover[to] = cover_of(share.data() + from, spline.data() + from, margin.width());
        }
    }
    paint_coefficients(film, cells, fields.paint_mm.data(), cells.width());
    return fields;
}

/// Well within the outline nothing of it is seen: the spline is nowhere lower than its coefficients.
constexpr float kWellWithin = 0.25F;

enum : std::uint8_t { kBare = 1, kPainted = 2, kMeet = kBare | kPainted };

/// Which are not well within, and which hold paint or its foot.
std::vector<std::uint8_t> kinds_of(const Fields& fields) {
    std::vector<std::uint8_t> kinds(fields.share.size());
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const bool painted = fields.share[i] > 0.0F || fields.paint_mm[i] > 0.0F;
        kinds[i] = static_cast<std::uint8_t>((fields.cover[i] < kWellWithin ? kBare : 0) |
                                             (painted ? kPainted : 0));
    }
    return kinds;
}

/// Every cell's kinds, and those of the three that follow it at that distance.
void join_blocks(std::vector<std::uint8_t>& kinds, std::size_t apart) {
    for (std::size_t i = 0; i + kBlock * apart < kinds.size(); ++i)
        for (std::size_t k = 1; k <= kBlock; ++k)
            kinds[i] |= kinds[i + k * apart];
}

/// Of the light that a cell's paint takes, in the band where it takes most: sqrt(K (K + 2 S)) h.
float hiding(const film::PaintCell& paint) {
    float most = 0.0F;
    for (int band = 0; band < pigment::kBands; ++band) {
        const float absorbed = film::optical_thickness(paint[band]);
        const float scattered = film::optical_thickness(paint[pigment::kBands + band]);
        most = std::max(most, absorbed * (absorbed + 2.0F * scattered));
    }
    return std::sqrt(most);
}

void put_hiding(const film::FilmState& film, const Rect& cells, float* out) {
    const auto fill = [&film](const Rect& part, float* target, int stride) {
        gather_cells(film.shape, part, target, stride, [&](int tile, int cell, int count, float* to) {
            const film::PaintCell* paint = film.paint.read(tile) + cell;
            for (int i = 0; i < count; ++i)
                to[i] = hiding(paint[i]);
        });
    };
    fill_beyond_edges(film.shape, cells, out, cells.width(), fill);
}

}  // namespace

void edge_sharpness(const film::FilmState& film, const Rect& cells, float* out, int stride) {
    const Rect margin = grown(cells, 1);
    std::vector<float> hidden(count_of(margin));
    put_hiding(film, margin, hidden.data());
    for (int y = 0; y < cells.height(); ++y) {
        const float* own = hidden.data() + static_cast<std::ptrdiff_t>(y + 1) * margin.width() + 1;
        for (int x = 0; x < cells.width(); ++x)
            out[static_cast<std::ptrdiff_t>(y) * stride + x] =
                std::clamp(most_around(own + x, margin.width(), 1) - 0.5F, 0.0F, 1.0F);
    }
}

void outline_cells(const film::FilmState& film, const Rect& cells, const OutlineCells& out, int stride) {
    const Rect reach{cells.x0, cells.y0, cells.x1 + kBlock, cells.y1 + kBlock};
    const Rect known = nearest_on_canvas(film.shape, reach);
    const Fields on_canvas = fields_on(film, known);
    Fields fields(reach);
    copy_nearest(on_canvas.share, known, reach, fields.share.data(), reach.width());
    copy_nearest(on_canvas.cover, known, reach, fields.cover.data(), reach.width());
    copy_nearest(on_canvas.paint_mm, known, reach, fields.paint_mm.data(), reach.width());
    std::vector<std::uint8_t> kinds = kinds_of(fields);
    join_blocks(kinds, 1);
    join_blocks(kinds, static_cast<std::size_t>(reach.width()));
    for (int y = 0; y < cells.height(); ++y) {
        const std::ptrdiff_t from = static_cast<std::ptrdiff_t>(y) * reach.width();
        const std::ptrdiff_t to = static_cast<std::ptrdiff_t>(y) * stride;
        std::copy_n(fields.share.data() + from, cells.width(), out.share + to);
        std::copy_n(fields.cover.data() + from, cells.width(), out.cover + to);
        for (int x = 0; x < cells.width(); ++x)
            out.near[to + x] = kinds[from + x] == kMeet ? 1 : 0;
    }
}

}  // namespace pastoso::shade
