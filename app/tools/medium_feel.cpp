#include "tools/medium_feel.hpp"

#include "tools/medium_numbers.hpp"

#include <utility>

namespace pastoso::tools {
namespace {

using film::Medium;

constexpr FeelNumber<Medium> kStiffToRunny[] = {
    {&Medium::viscosity_m2_s, 0.5, 2e-5, FeelScale::Logarithmic},
    {&Medium::yield_stress_Pa, 140.0, 0.0, FeelScale::CubeRoot}};

constexpr FeelNumber<Medium> kShortToLong[] = {
    {&Medium::advancing_angle_deg, 45.0, 15.0, FeelScale::Linear},
    {&Medium::alpha_min, 1.0, 0.8, FeelScale::Linear},
    {&Medium::alpha_max, 1.0, 1.2, FeelScale::Linear},
    {&Medium::flow_index, 0.7, 1.0, FeelScale::Linear}};

constexpr FeelNumber<Medium> kOpaqueToTransparent[] = {
    {&Medium::pigment_share, 1.0, 0.01, FeelScale::Logarithmic}};

}  // namespace

std::span<const FeelNumber<Medium>> numbers_of(Feel feel) {
    switch (feel) {
        case Feel::StiffToRunny:
            return kStiffToRunny;
        case Feel::ShortToLong:
            return kShortToLong;
        case Feel::OpaqueToTransparent:
            break;
    }
    return kOpaqueToTransparent;
}

double place_of(const Medium& medium, Feel feel) {
    return feel_place(medium, numbers_of(feel));
}

Medium with_place(Medium medium, Feel feel, double place) {
    return feel_moved(std::move(medium), numbers_of(feel), place,
                      [](Medium moved, const FeelNumber<Medium>& number, double value) {
                          return with_number(std::move(moved), number.member, value);
                      });
}

}  // namespace pastoso::tools
