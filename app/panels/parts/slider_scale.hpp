// A slider's steps and the values they stand for.
#pragma once

namespace pastoso::panels {

struct SliderScale {
    static constexpr int kSteps = 200;

    double least = 0.0, most = 1.0;  ///< at the slider's ends; most > least
    bool logarithmic = false;        ///< by equal factors from step to step; `least` is above 0

    /// Of a step from 0 to kSteps.
    double value_at(int step) const;

    /// The nearest step; of a value beyond an end, that end.
    int step_of(double value) const;
};

}  // namespace pastoso::panels
