// Baba and Saito's own scheme, as a reference that the product is compared with: thickness and velocity
// with their evolved x and y derivatives on one collocated periodic grid, moved by CIP. Plain double
// precision in cell units of the caller's choice; nothing here is fast.
//
// The paper gives, for h and u = (u, v) on a support c:
//     du/dt + (u . grad) u = -grad(p)/rho + nu (u_xx + u_yy + u_zz) + F,       (1)
//     u_zz = 6/(1 - 3 alpha) u/h^2,                                            (4)
//     T = sigma_s kappa n,  F = F_c + horizontal part of T,  grad(p) = grad(W) + grad(T_z),
//     grad(W) = rho g grad(h + c),
// alpha between alpha_min and alpha_max, linear in the inner product of T's direction with u's, and
// dh/dt + (u . grad) h = -h div(u). Each field changes first in time (the right-hand sides), then by
// advection.
//
// Where the paper is silent or cannot be meant as printed:
//  - T is a force per area: as an acceleration it is divided by rho h. `tension` is sigma_s/rho.
//  - With n inward and z upward, T_z < 0 over a drop and would suck it up; the pressure is W - T_z.
//  - The depth-integrated pressure contains the traction of the surface already, so that the horizontal
//    part of T counts it twice. Its weight `horizontal_tension` is 0 by default, 1 as printed.
//  - The cosine between u and T, a vector in space, is 0 where T or u vanishes, and k_d = 6/(3 alpha -
//  1) rather than u_zz is interpolated
//    (they are proportional).
//  - The drag is taken at the new time; everything else in (1) at the old one.
//  - CIP is Yabe and Aoki's (1991) type A: the cubic through four values and six derivatives.
//  - Nothing is said of the film's edge. Where h is below `dry_thickness`, the velocity is the mean of
//    the wet neighbours' (0 without any): with 0 there the front would never advance. The threshold
//    decides how much volume a moving front loses or gains; 0.3 cells did best of those tried.
//  - Nothing keeps h positive or the volume: negative h is cut (and counted), and `keep_volume` scales
//    h to the volume it began with.
#pragma once

#include <functional>
#include <vector>

namespace pastoso::film::test {

/// A periodic grid of points, row by row.
struct CipGrid {
    int width = 0, height = 0;
    double spacing = 1.0;

    int index(int x, int y) const;  ///< wraps around
    int count() const { return width * height; }
};

/// A function by its values and derivatives at the grid points.
struct CipField {
    explicit CipField(int count = 0) : value(count), slope_x(count), slope_y(count) {}
    std::vector<double> value, slope_x, slope_y;
};

/// Sets the derivatives to centred differences of the values.
void set_slopes(const CipGrid& grid, CipField& field);

/// f(x - velocity dt) by the cubic CIP interpolant of the upwind cell, with its derivatives. At most one
/// cell is crossed: |velocity| dt <= spacing.
CipField advected(const CipGrid& grid, const CipField& field, const std::vector<double>& velocity_x,
                  const std::vector<double>& velocity_y, double dt);

struct CipPaint {
    double gravity = 1.0;
    double tension = 0.0;             ///< sigma_s / rho
    double horizontal_tension = 0.0;  ///< weight of T's horizontal part
    double viscosity = 1.0;           ///< nu
    double force_x = 0.0, force_y = 0.0;
    double alpha_min = 1.0, alpha_max = 1.0;
    double dry_thickness = 0.3;
    bool keep_volume = false;
};

class CipReference {
  public:
    CipReference(const CipGrid& grid, const CipPaint& paint);

    void set_film(const std::function<double(int x, int y)>& thickness);
    void set_support(const std::function<double(int x, int y)>& height);
    void step(double dt);

    double h(int x, int y) const { return film_.value[grid_.index(x, y)]; }
    double u(int x, int y) const { return velocity_x_.value[grid_.index(x, y)]; }
    double v(int x, int y) const { return velocity_y_.value[grid_.index(x, y)]; }
    double volume() const;               ///< sum of h
    double cut() const { return cut_; }  ///< sum of negative h that was cut

  private:
    void find_pressure();
    double drag_coefficient(int i) const;
    void find_changes(double dt);
    void change_wet_velocity(int x, int y, double dt);
    void extrapolate_velocity(int x, int y);
    void apply(const std::vector<double>& change, double dt, CipField& field) const;
    void cut_negative();
    void restore_volume();

    CipGrid grid_;
    CipPaint paint_;
    CipField film_, velocity_x_, velocity_y_;
    std::vector<double> support_;
    std::vector<double> pressure_, tension_x_, tension_y_, tension_z_;         ///< p/rho and T/rho
    std::vector<double> film_change_, velocity_x_change_, velocity_y_change_;  ///< of one step
    double first_volume_ = 0.0, cut_ = 0.0;
};

}  // namespace pastoso::film::test
