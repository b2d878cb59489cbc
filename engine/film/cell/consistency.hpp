// In which consistency paint is: what tells whether a whole film flows alike.
#pragma once

#include "film/cell/paint_cell.hpp"

#include <optional>

namespace pastoso::film {

/// Viscosity and yield stress as paint carries them (paint_cell.hpp).
struct Consistency {
    float log_viscosity = 0.0F;    ///< ln(nu / kThinnest_m2_s)
    float yield_stress_Pa = 0.0F;  ///< tau_y
    friend bool operator==(const Consistency&, const Consistency&) = default;
};

Consistency consistency_of(const PaintCoefficients& paint);
/// That of fresh paint in this medium.
Consistency consistency_of(const Medium& medium);

/// The consistencies that the paint of a film or of a brush has: none yet, one, or several. More may be
/// named than there are, never fewer.
class Consistencies {
  public:
    Consistencies() = default;
    explicit Consistencies(const Consistency& only) : only_(only) {}
    /// Each cell's paint may have one of its own.
    static Consistencies several();

    /// More paint comes to it.
    void add(const Consistencies& more);
    void add(const Consistency& more) { add(Consistencies(more)); }

    bool are_several() const { return several_; }
    /// The one that all paint has; none where there are several, or where there is no paint.
    const std::optional<Consistency>& uniform() const { return only_; }
    /// Whether no paint has another one than this.
    bool are_only(const Consistency& one) const { return !several_ && only_.value_or(one) == one; }

    friend bool operator==(const Consistencies&, const Consistencies&) = default;

  private:
    std::optional<Consistency> only_;
    bool several_ = false;
};

}  // namespace pastoso::film
