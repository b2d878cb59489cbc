// The exact solutions that cases are held against, in millimetres and seconds. F is the force along the
// canvas, g gravity normal to it (mm/s2), nu the kinematic viscosity (mm2/s), sigma the surface tension
// over the density (mm3/s2), tau the yield stress over the density (mm2/s2), A an area, V a volume.
#pragma once

namespace pastoso::film::validation {

/// Mean speed of a film whose velocity profile peaks at alpha h: F h^2 (3 alpha - 1) / (6 nu). Nusselt
/// (1916) for alpha = 1.
double nusselt_speed(double force, double h, double viscosity, double alpha = 1.0);

/// A paint after Herschel and Bulkley (1926): tau_y + K gamma^n, over the density.
struct PlasticPaint {
    double consistency = 1.0;  ///< K/rho, mm2/s at a shear rate of 1/s
    double yield = 0.0;        ///< tau_y/rho
    double flow_index = 1.0;   ///< n
};

/// Mean speed of its film: h gamma n/(n+1) e (1 - n/(2n+1) e), gamma = ((F h - tau_y)/K)^(1/n), e = 1 -
/// tau_y/(F h); 0 below yield. Bingham's film for n = 1.
double plastic_speed(const PlasticPaint& paint, double force, double h);

/// Huppert's current on a slope (Nature 300, 1982): h = sqrt(nu x / (F t)) up to the front at
/// (9 A^2 F t / (4 nu))^(1/3).
struct SlopeCurrent {
    double area, force, viscosity;

    double front(double t) const;
    double h(double x, double t) const;
    double mean(double from, double to, double t) const;  ///< over a stretch
};

/// Huppert's axisymmetric current (J. Fluid Mech. 121, 1982): h = 4 V / (3 pi R^2) (1 - r^2/R^2)^(1/3),
/// R = 0.8944 (g V^3 t / (3 nu))^(1/8).
struct RoundCurrent {
    double volume, gravity, viscosity;

    double radius(double t) const;
    double height(double t) const;  ///< in the middle
    double h(double r, double t) const;
};

/// Rate at which a ripple of wavenumber k fades: h^3 (g k^2 + sigma k^4) / (3 nu). Orchard (1962).
double ripple_rate(double gravity, double tension, double h, double wavenumber, double viscosity);

/// What a yield stress leaves of a heap on a flat support, either side of its middle: h^2 = 2 tau/g (x_N
/// - x). Nye (1951).
struct YieldedHeap {
    double half_area, yield, gravity;

    double height() const;
    double reach() const;  ///< x_N
    double h(double x) const;
};

/// A strip of this section, flatter than its receding slope, draws back: after Cox and Voinov, matched
/// to a foot that slips, -da/dt = (sigma/nu) (theta_R^3 - theta^3) / (9 ln(2 a theta_R / (e^2 l))) with
/// the half-width a, theta = 3 A / (2 a^2) and l = 3 slip lengths. Savva and Kalliadasis (2009).
struct RetractingStrip {
    double section, receding, tension, viscosity, slip;

    double last_half_width() const;
    double retreat_speed(double half_width) const;
};

/// A level film, half of which has a surface tension that is lower by a step (sigma/rho): that half goes
/// out over the other as rate t^(1/2). On both sides h_t = (g/(3 nu) h^3 h_x)_x, and across the front
/// g (h2^2 - h1^2) = 3 step. Lubrication: Oron, Davis and Bankoff (1997).
struct TensionFront {
    double gravity, tension_step, viscosity, h;

    double rate() const;  ///< mm/s^(1/2)
};

/// Thickness behind a yield-stress current on a slope, at the distance x from its start: h (h - tau/F) =
/// x nu / (F t). Liu and Mei (1989).
double yielded_tail(double force, double yield, double viscosity, double x, double t);

}  // namespace pastoso::film::validation
