#include "random_scenes.hpp"

namespace pastoso::tank {
namespace {

/// Other seeds than those of the default tests.
TEST(ManyScenes, AThousandStayFinite) {
    cases::run_random_scenes(1000, 1000);
}

}  // namespace
}  // namespace pastoso::tank
