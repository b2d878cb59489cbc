// The bench of the validation with what tests need besides: paint that carries pigment and consistency.
#pragma once

#include "film/validation/bench.hpp"

#include <functional>
#include <string>

namespace pastoso::film::test {

using Scene = validation::Setup;

/// For test names.
std::string name_of(Edge edge);

/// Paint with an alpha range and a contact angle that runs down aslant.
Scene runny(int width, int height);

/// The thickness of a paraboloid drop in a cell.
double blob(double x, double y, double centre_x, double centre_y, double radius, double height);

class Bench : public validation::Bench {
  public:
    using validation::Bench::Bench;

    /// Sets one pigment channel to a concentration (per mm) everywhere.
    void tint(int channel, const std::function<double(int x, int y)>& per_mm);
    /// The largest |h - thickness| of all cells, mm.
    double largest_difference(const std::function<double(int x, int y)>& thickness_mm) const;
    /// Lets every cell carry the scene's viscosity and yield stress, as painted paint does.
    void carry_consistency();
};

}  // namespace pastoso::film::test
