#include "document/puddles.hpp"

#include "document/paint_reading.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

namespace pastoso::document {
namespace {

constexpr double kSquare_mm = 2.0;
constexpr double kLeast_mm3 = 25.0;  // a tenth of a dollop
constexpr double kNear_mm = 15.0;    // as far as a dollop reaches from its thick end
constexpr float kAlike = 0.2F;
constexpr double kSamePart = 0.02;

/// Whole quanta leave traces of paints that are not there.
constexpr double kPure = 0.99;

/// Below this, per mm, there is no pigment that could differ.
constexpr float kColourless_per_mm = 1e-3F;

/// Of cells that lie together, each as often as it is thick.
struct Middle {
    std::int64_t count = 0, sum_x = 0, sum_y = 0;

    void add(const Middle& other) {
        count += other.count;
        sum_x += other.sum_x;
        sum_y += other.sum_y;
    }
    double x() const { return static_cast<double>(sum_x) / static_cast<double>(count) + 0.5; }
    double y() const { return static_cast<double>(sum_y) / static_cast<double>(count) + 0.5; }
};

/// The wet paint of some cells.
struct Heap {
    std::int64_t thickness = 0;
    std::array<std::int64_t, film::kPigmentChannels> pigment{};
    Middle middle;

    void add(const Heap& other) {
        thickness += other.thickness;
        for (std::size_t k = 0; k < pigment.size(); ++k)
            pigment[k] += other.pigment[k];
    }
};

pigment::Coefficients mean_of(const Heap& heap) {
    const double per_quantum =
        film::kPaintQuantum / (static_cast<double>(heap.thickness) * film::kThicknessQuantum_mm);
    pigment::Coefficients per_mm{};
    for (std::size_t k = 0; k < heap.pigment.size(); ++k)
        per_mm[k] = static_cast<float>(static_cast<double>(heap.pigment[k]) * per_quantum);
    return per_mm;
}

bool are_alike(const pigment::Coefficients& a, const pigment::Coefficients& b) {
    float sum = 0.0F;
    for (std::size_t k = 0; k < a.size(); ++k) {
        const float apart = (a[k] - b[k]) / std::max({a[k], b[k], kColourless_per_mm});
        sum += apart * apart;
    }
    return sum < kAlike * kAlike * static_cast<float>(a.size());
}

/// What lies on each square with paint, the thickest first.
std::vector<Heap> heaps_on(const film::FilmState& well) {
    const int side = std::max(1, static_cast<int>(std::lround(kSquare_mm / well.cell_mm)));
    std::map<std::pair<int, int>, Heap> squares;
    for (int y = 0; y < well.shape.height; ++y)
        for (int x = 0; x < well.shape.width; ++x) {
            const std::int32_t thickness = well.thickness.at(x, y);
            if (thickness == 0) continue;
            Heap cell{.thickness = thickness,
                      .pigment = {},
                      .middle = {thickness, std::int64_t{thickness} * x, std::int64_t{thickness} * y}};
            for (std::size_t k = 0; k < cell.pigment.size(); ++k)
                cell.pigment[k] = well.paint.at(x, y)[k];
            Heap& square = squares[{y / side, x / side}];
            square.add(cell);
            square.middle.add(cell.middle);
        }
    std::vector<Heap> heaps;
    for (const auto& [square, heap] : squares)
        heaps.push_back(heap);
    std::stable_sort(heaps.begin(), heaps.end(),
                     [](const Heap& a, const Heap& b) { return a.thickness > b.thickness; });
    return heaps;
}

/// All that is like a square which is the thickest of it; its middle is that of what lies near that.
struct Gathered {
    Heap all;
    Middle thickest;
    pigment::Coefficients paint;

    void add(const Heap& heap, double near_cells) {
        all.add(heap);
        if (std::hypot(heap.middle.x() - thickest.x(), heap.middle.y() - thickest.y()) < near_cells)
            all.middle.add(heap.middle);
    }
};

std::vector<Gathered> gathered(const std::vector<Heap>& heaps, double cell_mm) {
    std::vector<Gathered> whole;
    for (const Heap& heap : heaps) {
        const pigment::Coefficients paint = mean_of(heap);
        const auto like = std::find_if(whole.begin(), whole.end(), [&](const Gathered& other) {
            return are_alike(paint, other.paint);
        });
        if (like == whole.end())
            whole.push_back({heap, heap.middle, paint});
        else
            like->add(heap, kNear_mm / cell_mm);
    }
    return whole;
}

double share_of(const std::string& pigment, const PaintRecipe& paint) {
    double own = 0.0, all = 0.0;
    for (const Ingredient& part : paint.ingredients) {
        own += part.pigment == pigment ? part.parts : 0.0;
        all += part.parts;
    }
    return own == 0.0 ? 0.0 : own / all;
}

bool has_as_much_of_all(const PaintRecipe& a, const PaintRecipe& b) {
    return std::all_of(a.ingredients.begin(), a.ingredients.end(), [&](const Ingredient& part) {
        return std::abs(share_of(part.pigment, a) - share_of(part.pigment, b)) < kSamePart;
    });
}

/// The largest part of a recipe that was read stands first.
bool is_mixture(const PaintRecipe& read) {
    return !read.ingredients.empty() && share_of(read.ingredients.front().pigment, read) < kPure;
}

}  // namespace

std::vector<Puddle> puddles_on(const film::FilmState& well, std::span<const std::string> names,
                               double pigment_share) {
    std::vector<Puddle> puddles;
    if (names.empty()) return puddles;
    for (const Gathered& part : gathered(heaps_on(well), well.cell_mm)) {
        const Heap& heap = part.all;
        const double volume_mm3 = film::volume_mm3(heap.thickness, well.cell_mm);
        if (volume_mm3 < kLeast_mm3) continue;
        const auto recipe = recipe_of(mean_of(heap), names, pigment_share);
        if (!recipe || !is_mixture(*recipe)) continue;
        puddles.push_back(
            {*recipe, volume_mm3, heap.middle.x() * well.cell_mm, heap.middle.y() * well.cell_mm});
    }
    std::stable_sort(puddles.begin(), puddles.end(),
                     [](const Puddle& a, const Puddle& b) { return a.volume_mm3 > b.volume_mm3; });
    puddles.resize(std::min(puddles.size(), kMostPuddles));
    return puddles;
}

bool are_alike(const PaintRecipe& a, const PaintRecipe& b) {
    return has_as_much_of_all(a, b) && has_as_much_of_all(b, a);
}

}  // namespace pastoso::document
