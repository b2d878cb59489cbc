#include "brush/transfer.hpp"

#include "brush/spill.hpp"
#include "brush/studio.hpp"
#include "core/random.hpp"

#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

constexpr double kCell_mm = 0.125;

/// A brush of four bristles, all full of the same paint.
Brush small_brush() {
    Brush brush(studio::flat_preset(2.0, 4));
    brush.load(studio::dark_paint(), 1.0);
    return brush;
}

Contact contact_at(double x_mm, double y_mm) {
    Contact contact;
    contact.x_mm = x_mm;
    contact.y_mm = y_mm;
    contact.press = 0.4F;
    return contact;
}

grid::Rect touch(Brush& brush, film::FilmState& film, const Contact& contact,
                 const HandPose& hand = HandPose{}) {
    CellBatch scratch;
    const ResolvedTip tip = resolve(brush.tip, brush.preset.paint, kCell_mm);
    const StepRates rates = step_rates(brush, tip, hand, 0.2);
    const ExchangeRule rule = exchange_rule(brush, 0, contact, rates);
    scratch.gather(film, contact.x_mm, contact.y_mm, tip.reach_mm);
    return apply_batch(scratch, plan_exchange(rule, scratch), touch_limits(brush, contact), 1, film,
                       brush.held[0]);
}

TEST(Exchange, GivesTheFilmWhatTheBristleLoses) {
    Brush brush = small_brush();
    film::FilmState film = studio::smooth(8.0, 8.0);
    const Contents before = brush.contents();
    const grid::Rect changed = touch(brush, film, contact_at(4.1, 3.9));
    Contents after = brush.contents();
    EXPECT_LT(after.volume_mm3, before.volume_mm3);
    after += studio::contents(film);
    EXPECT_LT(studio::balance_error(after, before), 1e-14);
    for (int y = 0; y < film.shape.height; ++y) {
        for (int x = 0; x < film.shape.width; ++x) {
            const bool inside = x >= changed.x0 && x < changed.x1 && y >= changed.y0 && y < changed.y1;
            if (!inside) {
                EXPECT_EQ(film.thickness.at(x, y), 0);
            }
        }
    }
}

TEST(Exchange, ClosesTheShareOfTheGapThatTheRuleSays) {
    // A bristle without grooves, hairs, edge or start on a smooth support: in its middle w = chi = 1.
    Preset preset = studio::flat_preset(2.0, 4);
    preset.paint.groove = preset.paint.hair = preset.paint.start = preset.paint.edge = 0.0;
    Brush brush(preset);
    brush.load(studio::dark_paint(), 1.0);
    brush.held[0].volume_mm3 = brush.tip.capacity_mm3;  // sat = 1
    film::FilmState film = studio::smooth(8.0, 8.0);
    const Contact contact = contact_at(4.0 + 0.5 * kCell_mm, 4.0 + 0.5 * kCell_mm);
    touch(brush, film, contact);
    const double tau_mm = preset.paint.film_mm * brush.tip.bristles[0].body * (1.0 - 0.5 * 0.4);
    const double rate = 1.0 - std::exp(-0.2 / (0.8 * brush.tip.radius_mm));
    const double share = resolve(brush.tip, brush.preset.paint, kCell_mm).share;
    EXPECT_NEAR(studio::thickness_mm(film, 32, 32), share * rate * tau_mm, 1e-6);  // single precision
}

TEST(Exchange, TakesPaintInTheWay) {
    Brush brush(studio::flat_preset(2.0, 4));
    film::FilmState film = studio::smooth(8.0, 8.0);
    studio::cover(film, 0.5, studio::light_paint());
    const Contents before = studio::contents(film);
    for (int i = 0; i < 10; ++i)
        touch(brush, film, contact_at(4.0, 4.0));
    EXPECT_GT(brush.held[0].volume_mm3, 0.0);
    Contents after = studio::contents(film);
    after += brush.contents();
    EXPECT_LT(studio::balance_error(after, before), 1e-14);
    EXPECT_LT(studio::thickness_mm(film, 32, 32), 0.5);
}

// What the dynamics make of the pen's pressure, tilt and speed.
TEST(StepRates, AreThePresetsNumbersTimesTheHandsFactors) {
    const Brush brush = small_brush();
    HandPose hand;
    hand.film = 0.5;
    hand.reach = 0.25;
    hand.pickup = 2.0;
    const ResolvedTip tip = resolve(brush.tip, brush.preset.paint, kCell_mm);
    const StepRates rates = step_rates(brush, tip, hand, 0.2);
    EXPECT_FLOAT_EQ(rates.film_mm, static_cast<float>(0.5 * brush.preset.paint.film_mm));
    EXPECT_FLOAT_EQ(rates.reach, static_cast<float>(0.25 * brush.preset.paint.reach));
    EXPECT_FLOAT_EQ(rates.pickup, static_cast<float>(2.0 * brush.preset.exchange.pickup));
    hand.pickup = 1000.0;
    EXPECT_EQ(step_rates(brush, tip, hand, 0.2).pickup, 1.0F);
}

TEST(Exchange, AHandThatTakesNothingUpLeavesPaintInTheWay) {
    Brush brush(studio::flat_preset(2.0, 4));
    film::FilmState film = studio::smooth(8.0, 8.0);
    studio::cover(film, 0.5, studio::light_paint());
    HandPose hand;
    hand.pickup = 0.0;
    EXPECT_TRUE(touch(brush, film, contact_at(4.0, 4.0), hand).empty());
    EXPECT_EQ(brush.held[0].volume_mm3, 0.0);
}

TEST(Exchange, SwapsColourWithoutMovingVolume) {
    Preset preset = studio::flat_preset(2.0, 4);
    preset.exchange.pickup = 0.0;
    Brush brush(preset);
    brush.load(studio::dark_paint(), 1.0);
    film::FilmState film = studio::smooth(8.0, 8.0);
    studio::cover(film, 2.0, studio::light_paint());  // higher than the bristle wants it anywhere
    const double held_mm3 = brush.held[0].volume_mm3;
    const double light_before = brush.held[0].paint[6];
    touch(brush, film, contact_at(4.0, 4.0));
    EXPECT_EQ(brush.held[0].volume_mm3, held_mm3);
    EXPECT_GT(brush.held[0].paint[6], light_before);
    EXPECT_GT(film.paint.at(32, 32)[0], 100);
}

TEST(Exchange, PigmentGoesWithTheLastOfThePaint) {
    Brush brush(studio::flat_preset(2.0, 4));
    brush.preset.exchange.pickup = 1.0;
    film::FilmState film = studio::smooth(8.0, 8.0);
    studio::cover(film, 0.001, studio::dark_paint());
    for (int i = 0; i < 200; ++i) {
        touch(brush, film, contact_at(4.0, 4.0));
        brush.clean();
    }
    EXPECT_EQ(film.thickness.at(32, 32), 0);
    for (const std::int32_t quanta : film.paint.at(32, 32))
        EXPECT_EQ(quanta, 0);
}

TEST(Exchange, GivesColourWithoutBias) {
    // Weak channels are fractions of a quantum a step; rounding must neither drop nor double them.
    Brush brush = small_brush();
    brush.clean();
    brush.load(studio::light_paint(), 1.0);
    film::FilmState film = studio::smooth(8.0, 8.0);
    for (int i = 0; i < 40; ++i)
        touch(brush, film, contact_at(2.0 + 0.1 * i, 4.0));
    const Contents given = studio::contents(film);
    for (int k = 0; k < film::kPaintChannels; ++k) {
        const double per_mm = given.paint[k] / given.volume_mm3;
        EXPECT_NEAR(per_mm / studio::light_paint()[k], 1.0, 0.02) << "channel " << k;
    }
}

TEST(Exchange, ReachesAcrossTileCorners) {
    Brush brush = small_brush();
    film::FilmState film = studio::smooth(16.0, 16.0);  // 128 x 128 cells, four tiles
    const Contents before = brush.contents();
    touch(brush, film, contact_at(8.0, 8.0));
    for (const auto& [x, y] : {std::pair{63, 63}, {64, 63}, {63, 64}, {64, 64}}) {
        EXPECT_GT(film.thickness.at(x, y), 0);
    }
    Contents after = studio::contents(film);
    after += brush.contents();
    EXPECT_LT(studio::balance_error(after, before), 1e-14);
}

TEST(Exchange, LeavesUntouchedTilesAndSnapshotsAlone) {
    Brush brush = small_brush();
    film::FilmState film = studio::smooth(16.0, 16.0);
    touch(brush, film, contact_at(4.0, 4.0));
    const film::FilmState snapshot = film;
    touch(brush, film, contact_at(4.2, 4.0));
    EXPECT_FALSE(film.thickness.shares_tile(snapshot.thickness, 0));
    for (int tile = 1; tile < 4; ++tile) {
        EXPECT_TRUE(film.thickness.is_background(tile));
        EXPECT_TRUE(film.paint.is_background(tile));
    }
}

TEST(Exchange, EmptyBristleOnDryCanvasChangesNothing) {
    Brush brush(studio::flat_preset(2.0, 4));
    film::FilmState film = studio::linen(8.0, 8.0);
    EXPECT_TRUE(touch(brush, film, contact_at(4.0, 4.0)).empty());
    EXPECT_TRUE(film.thickness.is_background(0));
    EXPECT_EQ(brush.contents(), Contents{});
}

TEST(Exchange, BeyondTheCanvasNothingHappens) {
    Brush brush = small_brush();
    film::FilmState film = studio::smooth(8.0, 8.0);
    const Contents before = brush.contents();
    for (const auto& [x, y] : {std::pair{-5.0, 4.0}, {4.0, 20.0}, {1e7, 1e7}, {-1e7, 0.0}}) {
        EXPECT_TRUE(touch(brush, film, contact_at(x, y)).empty());
    }
    touch(brush, film, contact_at(0.0, 0.0));  // a quarter of the footprint is on the canvas
    Contents after = studio::contents(film);
    EXPECT_GT(after.volume_mm3, 0.0);
    after += brush.contents();
    EXPECT_LT(studio::balance_error(after, before), 1e-14);
}

TEST(PutDown, HeapsUpNoMoreThanACellMayHold) {
    Contents held;
    held.volume_mm3 = 100.0;
    for (double& pigment : held.paint)
        pigment = 100.0 * kStrongestPaint_per_mm;
    const Contents before = held;
    film::FilmState film = studio::smooth(8.0, 8.0);
    CellBatch scratch;
    put_down(held, 90.0, 4.0, 4.0, 0.6, 1, film, scratch);
    double thickest_mm = 0.0;
    for (int y = 0; y < film.shape.height; ++y) {
        for (int x = 0; x < film.shape.width; ++x) {
            thickest_mm = std::max(thickest_mm, studio::thickness_mm(film, x, y));
            for (const std::int32_t quanta : film.paint.at(x, y))
                EXPECT_GE(quanta, 0);
        }
    }
    EXPECT_NEAR(thickest_mm, film::kMaxThickness_mm, 1e-5);
    held += studio::contents(film);
    EXPECT_LT(studio::balance_error(held, before), 1e-14);
}

// Paint that has dried on may hold more pigment than any paint from a tube.
TEST(PutDown, LeavesOutPigmentThatACellCannotCount) {
    Contents held;
    held.volume_mm3 = 100.0;
    for (double& pigment : held.paint)
        pigment = 100.0 * kStrongestPaint_per_mm;
    film::FilmState film = studio::smooth(8.0, 8.0);
    film::PaintCell strong;
    strong.fill(2'000'000'000);
    for (int y = 0; y < film.shape.height; ++y)
        for (int x = 0; x < film.shape.width; ++x) {
            film.thickness.set(x, y, static_cast<std::int32_t>(1.0 / film::kThicknessQuantum_mm));
            film.paint.set(x, y, strong);
        }
    Contents before = studio::contents(film);
    before += held;
    CellBatch scratch;
    put_down(held, 90.0, 4.0, 4.0, 0.6, 1, film, scratch);
    for (int y = 0; y < film.shape.height; ++y)
        for (int x = 0; x < film.shape.width; ++x)
            for (const std::int32_t quanta : film.paint.at(x, y))
                ASSERT_GE(quanta, 2'000'000'000);
    held += studio::contents(film);
    EXPECT_LT(studio::balance_error(held, before), 1e-14);
}

/// Random cells and a rule that reaches them, for comparing instruction sets.
struct RandomBatch {
    static constexpr int kCount = 96;
    std::vector<float> dx_mm, dy_mm, support_mm, touched;
    std::vector<std::int32_t> thickness, found, pass_found, worked, cell, change, swap, lower_thickness;
    std::vector<film::PaintCell> lower_paint;
    std::vector<float> profile;

    explicit RandomBatch(std::uint32_t seed)
        : touched(kCount), worked(kCount), change(kCount), swap(kCount), lower_paint(kCount) {
        const auto noise = [seed](int i, std::uint32_t stream) {
            return core::uniform_noise(static_cast<std::uint32_t>(i), seed * 16 + stream);
        };
        for (int i = 0; i < kCount; ++i) {
            dx_mm.push_back(1.2F * noise(i, 0) - 0.6F);
            dy_mm.push_back(1.2F * noise(i, 1) - 0.6F);
            support_mm.push_back(0.11F * noise(i, 2));
            const float wet_mm = noise(i, 3) < 0.3F ? 0.0F : noise(i, 4) * noise(i, 4) * 2.0F;
            thickness.push_back(static_cast<std::int32_t>(wet_mm / film::kThicknessQuantum_mm));
            const auto reached =
                static_cast<std::int32_t>(noise(i, 6) * 1.5F / film::kThicknessQuantum_mm);
            const bool is_settled = noise(i, 10) < 0.3F;
            found.push_back(is_settled ? -1 - reached : reached);
            cell.push_back(i);
            const bool two = noise(i, 7) < 0.5F;
            lower_thickness.push_back(two ? static_cast<std::int32_t>(noise(i, 8) * thickness[i]) : 0);
            if (lower_thickness[i] > 0)
                lower_paint[i].fill(static_cast<std::int32_t>(1e6F * noise(i, 9)));
        }
        for (int i = 0; i < 17; ++i)
            profile.push_back(noise(i, 5) - 0.5F);
        pass_found = found;
    }

    ExchangeRule rule(bool lane, bool side_by_side) const {
        ExchangeRule rule{};
        rule.across_x = 1.3F;
        rule.across_y = 1.1F;
        rule.along_x = -1.1F;
        rule.along_y = 1.3F;
        rule.lane = lane;
        rule.side_by_side = side_by_side;
        rule.lane_core = 0.7F;
        rule.underside_mm = 0.3F;
        rule.profile_mm = 0.1F;
        rule.profile = profile.data();
        rule.segments = 16;
        rule.lowest_mm = 0.02F;
        rule.fade_per_mm = 30.0F;
        rule.rate = 0.37F;
        rule.pickup = 0.35F;
        rule.mix = 0.4F;
        rule.mix_depth_mm = 0.8F;
        return rule;
    }

    BatchColumns columns() {
        return {dx_mm.data(),  dy_mm.data(), thickness.data(), found.data(), support_mm.data(),
                change.data(), swap.data(),  touched.data(),   kCount};
    }

    TileCells cells(std::vector<film::PaintCell>& pigment, const std::vector<std::int32_t>& held) {
        return {
            thickness.data(),  pigment.data(), worked.data(), cell.data(),    held.data(), found.data(),
            pass_found.data(), change.data(),  swap.data(),   touched.data(), kCount};
    }
    LowerCells lower() { return {lower_thickness.data(), lower_paint.data()}; }
};

bool holds_possible_strata(const RandomBatch& batch, const std::vector<film::PaintCell>& pigment) {
    for (int i = 0; i < RandomBatch::kCount; ++i)
        if (!film::is_part_of({batch.lower_thickness[i], batch.lower_paint[i]}, batch.thickness[i],
                              pigment[i]))
            return false;
    return true;
}

/// One stratum of `paint` in all cells, found by a pass that begins.
RandomBatch found_paint(std::vector<film::PaintCell>& pigment, const film::PaintCell& paint) {
    RandomBatch batch(1);
    constexpr auto kFound_quanta = static_cast<std::int32_t>(0.3 / film::kThicknessQuantum_mm);
    batch.thickness.assign(RandomBatch::kCount, kFound_quanta);
    batch.pass_found = batch.thickness;
    batch.lower_thickness.assign(RandomBatch::kCount, 0);
    batch.lower_paint.assign(RandomBatch::kCount, {});
    pigment.assign(RandomBatch::kCount, paint);
    return batch;
}

/// Lays 0.1 mm of a paint, which hides, onto all cells as they lie and are found.
void lay_onto(RandomBatch& batch, std::vector<film::PaintCell>& pigment,
              const film::PaintCoefficients& given) {
    constexpr auto kFilm_quanta = static_cast<std::int32_t>(0.1 / film::kThicknessQuantum_mm);
    ApplyRule rule;
    rule.given = given;
    std::fill(batch.change.begin(), batch.change.end(), kFilm_quanta);
    std::fill(batch.touched.begin(), batch.touched.end(), 0.5F);
    const std::vector<std::int32_t> held = batch.thickness;
    batch.found = batch.pass_found;
    ChangeSums changes;
    core::kernels<TransferKernels>().apply_strata(rule, batch.cells(pigment, held), batch.lower(),
                                                  changes);
}

TEST(ApplyStrata, APassBuriesWhatItFoundOnce) {
    std::vector<film::PaintCell> pigment;
    RandomBatch batch = found_paint(pigment, {0, 0, 5'000'000});
    const std::vector<std::int32_t> found = batch.thickness;
    lay_onto(batch, pigment, {0.5F});
    EXPECT_EQ(batch.lower_thickness, found);
    lay_onto(batch, pigment, {0.0F, 0.5F});
    EXPECT_EQ(batch.lower_thickness, found) << "the stroke's own paint is not buried";
    batch.pass_found = batch.thickness;
    const std::vector<std::int32_t> found_anew = batch.thickness;
    lay_onto(batch, pigment, {0.0F, 0.0F, 0.5F});
    EXPECT_EQ(batch.lower_thickness, found_anew);
}

// A tip that comes again with a little of what it found below.
TEST(ApplyStrata, PaintNearToTheUpperStratumJoinsIt) {
    std::vector<film::PaintCell> pigment;
    RandomBatch batch = found_paint(pigment, {0, 0, 5'000'000});
    const std::vector<std::int32_t> found = batch.thickness;
    lay_onto(batch, pigment, {0.5F});
    batch.pass_found = batch.thickness;
    lay_onto(batch, pigment, {0.45F, 0.0F, 0.05F});
    EXPECT_EQ(batch.lower_thickness, found);
}

TEST(Plan, SaysWhetherPaintThatWasFoundMayBeBuried) {
    const auto may_bury = [](std::int32_t found_quanta, float gain_mm) {
        RandomBatch batch(1);
        const std::int32_t held_quanta = std::max(found_quanta, settled(found_quanta));
        batch.thickness.assign(RandomBatch::kCount, held_quanta);
        batch.found.assign(RandomBatch::kCount, found_quanta);
        batch.support_mm.assign(RandomBatch::kCount, 0.0F);
        ExchangeRule rule = batch.rule(false, false);
        rule.lowest_mm = -1.0F;
        rule.underside_mm =
            static_cast<float>(held_quanta * film::kThicknessQuantum_mm) + gain_mm - rule.profile_mm;
        return core::kernels<TransferKernels>().plan(rule, batch.columns()).may_bury;
    };
    constexpr auto kThick_quanta = static_cast<std::int32_t>(0.3 / film::kThicknessQuantum_mm);
    EXPECT_TRUE(may_bury(kThick_quanta, 0.5F));
    EXPECT_FALSE(may_bury(settled(kThick_quanta), 0.5F)) << "it is settled in this pass";
    EXPECT_FALSE(may_bury(0, 0.5F)) << "nothing was found";
    EXPECT_FALSE(may_bury(film::kLeastStratum_quanta - 1, 0.5F)) << "too thin for a stratum";
}

TEST(Plan, SaysWhetherAnyCellChangesOrIsTouched) {
    const auto planned = [](float lowest_mm, float underside_mm) {
        RandomBatch batch(1);
        batch.support_mm.assign(RandomBatch::kCount, 0.0F);
        ExchangeRule rule = batch.rule(false, false);
        rule.lowest_mm = lowest_mm;
        rule.underside_mm = underside_mm;
        return core::kernels<TransferKernels>().plan(rule, batch.columns());
    };
    constexpr auto kHigh_mm = 1.1F * static_cast<float>(film::kMaxThickness_mm);
    const WantedSums clear = planned(kHigh_mm, kHigh_mm);
    EXPECT_FALSE(clear.changes);
    EXPECT_FALSE(clear.touches) << "it hangs above all paint";
    const WantedSums laid = planned(-1.0F, kHigh_mm);
    EXPECT_TRUE(laid.changes);
    EXPECT_TRUE(laid.touches);
    EXPECT_TRUE(planned(-1.0F, -1.0F).changes) << "it takes paint";
}

class EveryInstructionSet : public testing::TestWithParam<core::Isa> {};

TEST_P(EveryInstructionSet, GivesTheSameBitsAsTheBaseline) {
    if (GetParam() > core::best_isa())
        GTEST_SKIP() << "this processor has no " << core::name_of(GetParam());
    const auto& baseline = core::kernels<TransferKernels>(core::Isa::Baseline);
    const auto& kernels = core::kernels<TransferKernels>(GetParam());
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        RandomBatch expected(seed), actual(seed);
        const bool lane = seed % 2 == 1, side_by_side = seed % 4 == 1;
        const WantedSums expected_sums =
            baseline.plan(expected.rule(lane, side_by_side), expected.columns());
        const WantedSums sums = kernels.plan(actual.rule(lane, side_by_side), actual.columns());
        EXPECT_EQ(sums.deposit, expected_sums.deposit) << "seed " << seed;
        EXPECT_EQ(sums.swap, expected_sums.swap) << "seed " << seed;
        EXPECT_EQ(sums.may_bury, expected_sums.may_bury) << "seed " << seed;
        EXPECT_EQ(sums.changes, expected_sums.changes) << "seed " << seed;
        EXPECT_EQ(sums.touches, expected_sums.touches) << "seed " << seed;
        EXPECT_EQ(actual.change, expected.change) << "seed " << seed;
        EXPECT_EQ(actual.swap, expected.swap) << "seed " << seed;
        EXPECT_EQ(actual.touched, expected.touched) << "seed " << seed;

        ApplyRule rule;
        rule.deposit_scale = 0.83F;
        rule.swap_scale = 0.91F;
        rule.dither_seed = seed;
        for (int k = 0; k < film::kPaintChannels; ++k)
            rule.given[k] = 0.37F * static_cast<float>(k * k) / 12.0F;
        std::vector<film::PaintCell> expected_pigment(RandomBatch::kCount), actual_pigment;
        for (auto& cell : expected_pigment)
            cell.fill(1000003);
        actual_pigment = expected_pigment;
        ChangeSums expected_changes, changes;
        const std::vector<std::int32_t> held = expected.thickness;
        baseline.apply(rule, expected.cells(expected_pigment, held), expected_changes);
        kernels.apply(rule, actual.cells(actual_pigment, held), changes);
        EXPECT_EQ(actual.thickness, expected.thickness) << "seed " << seed;
        EXPECT_EQ(actual_pigment, expected_pigment) << "seed " << seed;
        EXPECT_EQ(changes.thickness, expected_changes.thickness);
        EXPECT_EQ(changes.paint, expected_changes.paint);
    }
}

TEST_P(EveryInstructionSet, ChangesStrataAsTheBaselineDoes) {
    if (GetParam() > core::best_isa())
        GTEST_SKIP() << "this processor has no " << core::name_of(GetParam());
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        RandomBatch expected(seed), actual(seed);
        ApplyRule rule;
        rule.deposit_scale = 0.83F;
        rule.swap_scale = 0.91F;
        rule.depth = seed % 3 == 0 ? 0.0F : 0.2F;
        rule.dither_seed = seed;
        for (int k = 0; k < film::kPaintChannels; ++k)
            rule.given[k] = 0.37F * static_cast<float>(k * k) / 12.0F;
        const auto run = [&](core::Isa isa, RandomBatch& batch, std::vector<film::PaintCell>& pigment) {
            const auto& kernels = core::kernels<TransferKernels>(isa);
            kernels.plan(batch.rule(seed % 2 == 1, seed % 4 == 1), batch.columns());
            pigment.assign(RandomBatch::kCount, {});
            for (auto& cell : pigment)
                cell.fill(1000003);
            const std::vector<std::int32_t> held = batch.thickness;
            ChangeSums changes;
            kernels.apply_strata(rule, batch.cells(pigment, held), batch.lower(), changes);
            std::int64_t grown = 0, thicker = 0;
            for (int i = 0; i < RandomBatch::kCount; ++i) {
                grown += pigment[i][5] - 1000003;
                thicker += batch.thickness[i] - held[i];
            }
            EXPECT_EQ(changes.paint[5], grown);
            EXPECT_EQ(changes.thickness, thicker);
            EXPECT_TRUE(holds_possible_strata(batch, pigment)) << "seed " << seed;
        };
        std::vector<film::PaintCell> expected_pigment, pigment;
        run(core::Isa::Baseline, expected, expected_pigment);
        run(GetParam(), actual, pigment);
        EXPECT_EQ(actual.thickness, expected.thickness) << "seed " << seed;
        EXPECT_EQ(pigment, expected_pigment) << "seed " << seed;
        EXPECT_EQ(actual.lower_thickness, expected.lower_thickness) << "seed " << seed;
        EXPECT_EQ(actual.lower_paint, expected.lower_paint) << "seed " << seed;
        EXPECT_EQ(actual.pass_found, expected.pass_found) << "seed " << seed;
        EXPECT_EQ(actual.worked, expected.worked) << "seed " << seed;
    }
}

INSTANTIATE_TEST_SUITE_P(Kernels, EveryInstructionSet,
                         testing::Values(core::Isa::Baseline, core::Isa::Avx2, core::Isa::Avx512),
                         [](const auto& isa) { return core::name_of(isa.param); });

}  // namespace
}  // namespace pastoso::brush
