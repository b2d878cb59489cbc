#include "pigment/colour_metric.hpp"

#include "pigment/lab.hpp"

#include <cmath>

namespace pastoso::pigment {
namespace {

double length(double a, double b) {
    return std::sqrt(a * a + b * b);
}

/// CIEDE2000's G, which stretches a near the greys.
double stretch_near_greys(double chroma) {
    const double c3 = chroma * chroma * chroma, c7 = c3 * c3 * chroma;
    return 0.5 * (1.0 - std::sqrt(c7 / (c7 + 6103515625.0)));
}

/// Adds weight * v v' to the matrix.
void add_outer_product(Matrix3& matrix, const Vector3& v, double weight) {
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            matrix[i][j] += weight * v[i] * v[j];
}

}  // namespace

Matrix3 colour_metric(const Vector3& xyz, const Vector3& white) {
    Vector3 value{}, slope{};  // of Lab's curve
    for (int i = 0; i < 3; ++i) {
        value[i] = lab_curve(xyz[i] / white[i]);
        slope[i] = lab_curve_slope(xyz[i] / white[i]) / white[i];
    }
    const Vector3 lightness = {0.0, 116.0 * slope[1], 0.0};
    Vector3 a = {500.0 * slope[0], -500.0 * slope[1], 0.0};
    const Vector3 b = {0.0, 200.0 * slope[1], -200.0 * slope[2]};

    const double from_middle = 116.0 * value[1] - 66.0;
    const double plain_a = 500.0 * (value[0] - value[1]), b_value = 200.0 * (value[1] - value[2]);
    const double stretch = 1.0 + stretch_near_greys(length(plain_a, b_value));
    const double a_value = stretch * plain_a;
    for (double& component : a)
        component *= stretch;
    const double chroma = length(a_value, b_value);
    const double cosine = chroma > 0.0 ? a_value / chroma : 1.0;
    const double sine = chroma > 0.0 ? b_value / chroma : 0.0;
    Vector3 along{}, across{};
    for (int i = 0; i < 3; ++i) {
        along[i] = cosine * a[i] + sine * b[i];
        across[i] = cosine * b[i] - sine * a[i];
    }
    const double squared = from_middle * from_middle;
    const double sl = 1.0 + 0.015 * squared / std::sqrt(20.0 + squared);
    const double sc = 1.0 + 0.045 * chroma, sh = 1.0 + 0.015 * chroma;
    Matrix3 metric{};
    add_outer_product(metric, lightness, 1.0 / (sl * sl));
    add_outer_product(metric, along, 1.0 / (sc * sc));
    add_outer_product(metric, across, 1.0 / (sh * sh));
    return metric;
}

}  // namespace pastoso::pigment
