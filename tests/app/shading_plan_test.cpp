#include "screen/shading_plan.hpp"

#include <gtest/gtest.h>

namespace pastoso::screen {
namespace {

constexpr QRect kWindow(0, 0, 1000, 800);
constexpr double kZoom = 2.0;  // one sample a pixel is then full quality

std::int64_t area(const QRegion& region) {
    std::int64_t pixels = 0;
    for (const QRect& rect : region)
        pixels += static_cast<std::int64_t>(rect.width()) * rect.height();
    return pixels;
}

/// Makes the plan believe in this cost of a sample.
void teach(ShadingPlan& plan, double seconds_per_sample) {
    const ShadingPlan::Job job{QRegion(kWindow), Quality::Full, 1.0};
    for (int i = 0; i < 50; ++i)
        plan.measured(job.samples(), seconds_per_sample * job.samples());
}

TEST(ShadingPlan, AFastCardIsNeverAskedForADraft) {
    ShadingPlan plan;
    teach(plan, 1e-9);
    plan.add_damage(kWindow);
    const ShadingPlan::Job job = plan.take_damage(kWindow, kZoom);
    EXPECT_EQ(job.quality, Quality::Full);
    EXPECT_EQ(area(job.region), area(QRegion(kWindow)));
    EXPECT_FALSE(plan.has_drafts());
}

TEST(ShadingPlan, ASlowCardDraftsLargeDamageAndShadesSmallDamageFully) {
    ShadingPlan plan;
    teach(plan, 100e-9);
    plan.add_damage(kWindow);
    EXPECT_EQ(plan.take_damage(kWindow, kZoom).quality, Quality::Coarse);
    EXPECT_TRUE(plan.has_drafts());
    plan.add_damage(QRect(100, 100, 120, 120));
    EXPECT_EQ(plan.take_damage(kWindow, kZoom).quality, Quality::Full);
}

TEST(ShadingPlan, RefinementCoversEveryDraftedPixelOnce) {
    ShadingPlan plan;
    teach(plan, 100e-9);
    plan.add_damage(kWindow);
    plan.take_damage(kWindow, kZoom);
    plan.add_damage(QRect(0, 0, 200, 100));  // small: shaded fully at once, no longer a draft
    plan.take_damage(kWindow, kZoom);
    EXPECT_FALSE(plan.can_refine());
    plan.let_drafts_cool();
    plan.let_drafts_cool();
    QRegion refined;
    std::int64_t pixels = 0;
    int strips = 0;
    while (plan.has_drafts()) {
        const ShadingPlan::Job job = plan.take_refinement(kZoom);
        ASSERT_FALSE(job.region.isEmpty());
        EXPECT_EQ(job.quality, Quality::Full);
        refined += job.region;
        pixels += area(job.region);
        ++strips;
    }
    EXPECT_EQ(refined, QRegion(kWindow) - QRect(0, 0, 200, 100));
    EXPECT_EQ(pixels, area(refined));
    EXPECT_GT(strips, 1);
}

TEST(ShadingPlan, PaintThatMovesOnDoesNotKeepTheRestCoarse) {
    ShadingPlan plan;
    teach(plan, 1e-6);
    const QRect moving(0, 0, 1000, 400);
    plan.add_damage(kWindow);
    plan.take_damage(kWindow, kZoom);
    for (int i = 0; i < 3; ++i) {
        plan.add_damage(moving);
        plan.take_damage(kWindow, kZoom);
        plan.let_drafts_cool();
    }
    ASSERT_TRUE(plan.can_refine());
    QRegion refined;
    while (plan.can_refine())
        refined += plan.take_refinement(kZoom).region;
    EXPECT_EQ(refined, QRegion(kWindow) - moving);
}

TEST(ShadingPlan, ASmallerPictureIsFirstPlainThenSampledFinely) {
    ShadingPlan plan;
    teach(plan, 10e-9);  // 800,000 samples in 8 ms
    plan.add_damage(kWindow);
    EXPECT_EQ(plan.take_damage(kWindow, 0.5).quality, Quality::Plain);
    EXPECT_EQ(samples_per_side(Quality::Full, 0.5), 4);
    EXPECT_EQ(samples_per_side(Quality::Full, 1.0), 2);
    EXPECT_EQ(samples_per_side(Quality::Full, 2.0), 1);
    EXPECT_EQ(samples_per_side(Quality::Fair, 0.5), 2);
    EXPECT_EQ(samples_per_side(Quality::Fair, 0.3), 4);
    EXPECT_EQ(samples_per_side(Quality::Fair, 1.0), 1);
}

TEST(ShadingPlan, DamageOutsideTheWindowIsDropped) {
    ShadingPlan plan;
    plan.add_damage(QRect(-500, -500, 100, 100));
    EXPECT_TRUE(plan.take_damage(kWindow, kZoom).region.isEmpty());
    EXPECT_FALSE(plan.has_damage());
}

TEST(ShadingPlan, AShiftedPictureIsShadedWhereItComesIn) {
    ShadingPlan plan;
    teach(plan, 100e-9);
    plan.add_damage(QRect(10, 10, 20, 20));
    plan.shift({30, -40}, kWindow);
    QRegion wanted = QRegion(kWindow) - kWindow.translated(30, -40);
    EXPECT_EQ(wanted.boundingRect(), kWindow);
    const QRegion still = QRegion(QRect(40, -30, 20, 20)) & kWindow;
    EXPECT_EQ(plan.take_damage(kWindow, kZoom).region, wanted + still);
}

TEST(ShadingPlan, WhatIsKeptOfAPictureIsADraft) {
    ShadingPlan plan;
    teach(plan, 100e-9);
    const QRegion kept(QRect(100, 100, 500, 400));
    plan.keep_as_draft(kept, kWindow);
    const ShadingPlan::Job job = plan.take_damage(kWindow, kZoom);
    EXPECT_EQ(job.region, QRegion(kWindow) - kept);
    plan.let_drafts_cool();
    plan.let_drafts_cool();
    QRegion refined;
    while (plan.has_drafts())
        refined += plan.take_refinement(kZoom).region;
    EXPECT_EQ(refined, QRegion(kWindow)) << "both have been drafted";
}

TEST(ShadingPlan, AFastCardMovesNoPicture) {
    ShadingPlan plan;
    teach(plan, 1e-9);
    EXPECT_TRUE(plan.is_quick(kWindow, kZoom));
    teach(plan, 100e-9);
    EXPECT_FALSE(plan.is_quick(kWindow, kZoom));
}

}  // namespace
}  // namespace pastoso::screen
