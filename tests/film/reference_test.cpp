// The product against the recorded results, line by line: within the demanded tolerances of the exact
// values, and close to what the other implementation of the same scheme gave, which was of first order
// in time. What was recorded has five digits.
#include "core/text_file.hpp"
#include "film/explicit/step_length.hpp"
#include "film/reference_data.hpp"
#include "film/thin_film_cases.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace pastoso::film::test {
namespace {

/// The tables also hold runs of a scheme that was given up; those of the explicit one have K = 0.
bool is_explicit(const ReferenceRow& row) {
    return row.text("K") == "0";
}

double demanded_decay_error(const std::string& kind, int cells_per_wave) {
    if (kind == "gravity") return 0.005;
    return cells_per_wave == 16 ? 0.04 : cells_per_wave == 32 ? 0.02 : 0.015;
}

TEST(Recorded, RippleDecay) {
    const std::vector<ReferenceRow> rows = reference_table("decay.csv");
    int compared = 0;
    for (const ReferenceRow& row : rows) {
        const std::string& kind = row.text("kind");
        const int n = static_cast<int>(row.number("cells_per_wave"));
        // The slowest ripple of all takes 400,000 steps: it is in the long set.
        if (!is_explicit(row) || (kind == "capillary" && n == 64)) continue;
        const double rate =
            ripple_decay_rate(kind == "capillary" ? 0 : 1, kind == "gravity" ? 0 : 20, n);
        EXPECT_NEAR(rate / row.number("rate_exact"), 1.0, demanded_decay_error(kind, n)) << kind << n;
        // Slow ripples move less than the coarser quantum of the record now and then.
        EXPECT_NEAR(rate / row.number("rate_num"), 1.0, 2e-3) << kind << n;
        ++compared;
    }
    EXPECT_EQ(compared, 8);
}

TEST(Recorded, SlopeCurrent) {
    const std::vector<ReferenceRow> rows = reference_table("slope_current.csv");
    for (const double cell : {1.0, 0.5}) {
        const std::vector<SlopeCurrent> currents = slope_current(cell, {20, 40, 80, 160});
        std::size_t next = 0;
        for (const ReferenceRow& row : rows) {
            if (row.number("dx") != cell) continue;
            const SlopeCurrent& current = currents.at(next++);
            EXPECT_NEAR(current.front / row.number("xN_exact"), 1.0, 0.01) << cell << ' ' << next;
            EXPECT_NEAR(current.front / row.number("xN_num"), 1.0, 1e-3) << cell << ' ' << next;
            EXPECT_LT(current.l1_error, 0.03) << cell << ' ' << next;
            EXPECT_LT(current.l1_error, row.number("L1_profile_rel") + 2e-4) << cell << ' ' << next;
        }
        EXPECT_EQ(next, 4U);
    }
}

TEST(Recorded, AxisymmetricCurrent) {
    const std::vector<ReferenceRow> rows = reference_table("axisym.csv");
    for (const double cell : {1.0, 0.5}) {
        std::vector<ReferenceRow> wanted;
        std::vector<double> times;
        for (const ReferenceRow& row : rows)
            if (is_explicit(row) && row.number("dx") == cell) {
                wanted.push_back(row);
                times.push_back(row.number("t"));
            }
        ASSERT_EQ(wanted.size(), 5U);
        const std::vector<SpreadDrop> drops = axisymmetric_current(cell, times);
        for (std::size_t i = 0; i < drops.size(); ++i) {
            const SpreadDrop& drop = drops[i];
            ASSERT_NEAR(drop.seconds, times[i], 1e-4);
            EXPECT_NEAR(drop.radius / wanted[i].number("rN_num_area"), 1.0, 4e-3) << times[i];
            EXPECT_NEAR(drop.height / wanted[i].number("h0_num"), 1.0, 4e-3) << times[i];
            EXPECT_NEAR(drop.radius / wanted[i].number("rN_exact"), 1.0, 0.03) << times[i];
            // The steep rim of the start takes until t = 4 to be forgotten.
            if (times[i] > 3) {
                EXPECT_NEAR(drop.height / wanted[i].number("h0_exact"), 1.0, 0.03) << times[i];
            }
        }
    }
}

// The first four lines have alpha = 1, the others the range from 0.5 to 1.2. The record held the rear of
// a drop longer than its receding angle does, and its drops ran by 4 % less far. With the range it took
// the surface tension in the plane (docs/decisions/0011), where the drag hangs on the sign of a
// curvature near 0.
TEST(Recorded, DripsInFourDirections) {
    const std::vector<ReferenceRow> rows = reference_table("rotation.csv");
    ASSERT_EQ(rows.size(), 8U);
    SolverOptions in_plane;
    in_plane.tension_in_space = false;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const bool one_alpha = i < 4;
        const ReferenceRow& row = rows[i];
        const Drip result =
            drip(row.number("angle"), one_alpha ? 1.0 : 0.5, one_alpha ? 1.0 : 1.2, in_plane);
        const double centroid = 0.045, cells = 2.5;
        EXPECT_NEAR(result.centroid / row.number("centroid"), 1.0, centroid) << i;
        EXPECT_NEAR(result.tip, row.number("tip"), cells) << i;
        EXPECT_NEAR(result.half_width, row.number("width"), cells) << i;
    }
}

// The exact cap, for small slopes the parabola. The small-slope curvature at a slope of 1 is not held to
// it: 10 % too low, as recorded.
TEST(Recorded, SessileCap) {
    const std::vector<ReferenceRow> rows = reference_table("sessile.csv");
    for (const ReferenceRow& row : rows) {
        const double cell = row.number("dx"), slope = row.number("tan");
        const bool full = row.number("fullcurv") != 0;
        const double height = row.number("h0_exact");
        const Cap cap = sessile_cap(cell, slope, full, height, cell == 1 ? 120 : 40);
        SCOPED_TRACE(testing::Message() << "cell " << cell << ", slope " << slope << ", full " << full);
        const bool is_cap = full || slope < 1;
        EXPECT_NEAR(cap.radius / row.number("R_exact"), 1.0, is_cap ? 0.015 : 0.04);  // reached 1.1 %
        EXPECT_NEAR(cap.height / height, 1.0, is_cap ? 0.02 : 0.12);                  // reached 1.8 %
    }
}

TEST(Recorded, YieldStress) {
    const std::vector<ReferenceRow> rows = reference_table("yield.csv");
    for (const ReferenceRow& row : rows) {
        const std::string& name = row.text("case");
        const double exact = row.number("exact"), recorded = row.number("num");
        const double last = name.back() == '5' ? 0.5 : 1.0;  // cell size, where the name ends with it
        if (name.starts_with("bingham_film_h")) {
            const Scene scene{
                .width = 16, .height = 2, .gravity = 10, .force_x = 2, .viscosity = 0.5, .yield = 1};
            const double u = terminal_velocity(scene, std::stod(name.substr(14)), 0.02, 80);
            EXPECT_NEAR(u / exact, 1.0, 1e-3) << name;
            EXPECT_NEAR(u / recorded, 1.0, 1e-4) << name;
        } else if (name.starts_with("flat_arrest_h0_dx")) {
            const double h0 = arrested_height(last);
            EXPECT_NEAR(h0 / exact, 1.0, 0.02) << name;
            EXPECT_NEAR(h0 / recorded, 1.0, 2e-3) << name;
        } else {
            // The exact value belongs to infinite time; validation_test checks the way there.
            ASSERT_TRUE(name.starts_with("slope_hy_dx")) << name;
            EXPECT_NEAR(slope_deposit(last) / recorded, 1.0, 1e-3) << name;
        }
    }
}

// The stability limit (l + sqrt(l^2 + 4 w^2)) / w^2 of the table from its own wave limit 2/w and drag
// rate l, all with three digits, and the product's from the same numbers.
TEST(Recorded, StabilityLimits) {
    const std::vector<ReferenceRow> rows = reference_table("limits.csv");
    ASSERT_EQ(rows.size(), 15U);
    for (const ReferenceRow& row : rows) {
        const double cell = row.number("dx"), h = row.number("h"), nu = row.number("nu");
        const bool cell_units = cell == 1.0;
        const double gravity = cell_units ? 1.0 : 9.81, wave_number2 = 8 / (cell * cell);
        const double w = 2 / row.number("dt_capillary_wave");  // gravity and tension together
        const double tension = (w * w / (h * wave_number2) - gravity) / wave_number2;
        const double mm = cell_units ? 1.0 : 1e3;
        const StepLimits limits{.cell_mm = cell * mm,
                                .gravity_mm_s2 = gravity * mm,
                                .tension = tension * mm * mm * mm,
                                .viscosity_mm2_s = nu * mm * mm};
        const std::string& name = row.text("name");
        EXPECT_NEAR(limits.newtonian_step_s(h * mm) / row.number("dt_FB"), 1.0, 0.02) << name << cell;
        EXPECT_NEAR(limits.wave_step_s(h * mm, 0) / row.number("dt_capillary_wave"), 1.0, 1e-9) << name;
        const StepLimits waves{.cell_mm = cell * mm, .gravity_mm_s2 = gravity * mm};
        EXPECT_NEAR(waves.wave_step_s(h * mm, 0) / row.number("dt_gravity_wave"), 1.0, 5e-3) << name;
    }
}

/// Mean error of n cells against the means of a finer solution.
double error_against(const std::vector<double>& fine, const std::vector<double>& coarse) {
    const std::size_t block = fine.size() / coarse.size();
    double error = 0;
    for (std::size_t i = 0; i < coarse.size(); ++i) {
        double mean = 0;
        for (std::size_t k = 0; k < block; ++k)
            mean += fine[i * block + k] / static_cast<double>(block);
        error += std::abs(coarse[i] - mean) / static_cast<double>(coarse.size());
    }
    return error;
}

TEST(Recorded, WavesConvergeToTheRecordedFineSolution) {
    const std::vector<ReferenceRow> rows = reference_table("order_ref.csv");
    std::vector<double> fine;
    for (const ReferenceRow& row : rows)
        fine.push_back(row.number("h"));
    ASSERT_EQ(fine.size(), 512U);
    double previous = 0;
    for (const int n : {16, 32, 64, 128}) {
        const double error = error_against(fine, levelled_waves(n));
        if (previous > 0) {
            EXPECT_GT(std::log2(previous / error), 1.4) << n;  // reached 2.1, 1.5, 1.9
        }
        previous = error;
    }
    // The recorded scheme comes within 1.8e-6 of this in a quarter of its steps.
    EXPECT_LT(error_against(fine, levelled_waves(512)), 1e-5);
}

nlohmann::json exact_values() {
    return nlohmann::json::parse(core::read_text_file(reference_path("reference.json")));
}

// The other exact values stand in the tables too, which the tests above compare with.
TEST(Recorded, ExactValuesAreThoseOfTheTables) {
    const nlohmann::json exact = exact_values();
    constexpr double kDigits = 2e-5;  // the tables have five or six
    for (const ReferenceRow& row : reference_table("decay.csv")) {
        const std::string& kind = row.text("kind");
        for (const auto& decay : exact.at("linear_decay")) {
            const bool same = decay.at("cells_per_wave") == row.number("cells_per_wave") &&
                              (decay.at("g") == 0) == (kind == "capillary") &&
                              (decay.at("sig") == 0) == (kind == "gravity");
            if (same) {
                EXPECT_NEAR(row.number("rate_exact") / decay.at("rate").get<double>(), 1.0, kDigits);
            }
        }
    }
    for (const ReferenceRow& row : reference_table("slope_current.csv"))
        for (const auto& front : exact.at("huppert_slope").at("front"))
            if (front.at(0) == row.number("t")) {
                EXPECT_NEAR(row.number("xN_exact") / front.at(1).get<double>(), 1.0, kDigits);
            }
    for (const ReferenceRow& row : reference_table("sessile.csv"))
        for (const auto& cap : exact.at("sessile_cap"))
            if (cap.at("tan") == row.number("tan")) {
                const char* height = row.number("fullcurv") != 0 ? "full_h0" : "small_slope_h0";
                EXPECT_NEAR(row.number("h0_exact") / cap.at(height).get<double>(), 1.0, kDigits);
            }
    const double arrested = exact.at("yield").at("flat_arrest").at("h0");
    for (const ReferenceRow& row : reference_table("yield.csv"))
        if (row.text("case").starts_with("flat_arrest_h0")) {
            EXPECT_NEAR(row.number("exact") / arrested, 1.0, kDigits);
        }
}

TEST(Recorded, NusseltAndBinghamFilms) {
    const nlohmann::json exact = exact_values();
    for (const auto& film : exact.at("nusselt")) {
        const double alpha = film.at("alpha"), h = film.at("h");
        const Scene scene{.width = 16,
                          .height = 2,
                          .gravity = 1,
                          .force_x = film.at("F"),
                          .viscosity = film.at("nu"),
                          .alpha_min = alpha,
                          .alpha_max = alpha};
        EXPECT_NEAR(terminal_velocity(scene, h, 0.05, 150) / film.at("u").get<double>(), 1.0, 1e-4)
            << film;
    }
    for (const auto& film : exact.at("bingham_film")) {
        const Scene scene{.width = 16,
                          .height = 2,
                          .gravity = 10,
                          .force_x = film.at("F"),
                          .viscosity = film.at("nu"),
                          .yield = film.at("tau_over_rho")};
        const double u = terminal_velocity(scene, film.at("h"), 0.02, 80), wanted = film.at("u");
        EXPECT_NEAR(u, wanted, 1e-3 * wanted) << film;  // exactly 0 below yield
    }
}

}  // namespace
}  // namespace pastoso::film::test
