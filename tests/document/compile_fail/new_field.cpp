// Whoever does something to each field of a painting has to know what to do with all of them.
#include "document/painting_value.hpp"

namespace pastoso::document {

/// Knows every field but the tracing.
struct Forgetful {
    template <class Field>
    requires(!std::is_same_v<Field, SharedTracing>) void operator()(const Field&) const {}
#ifndef WITHOUT_TRACING
    void operator()(const SharedTracing&) const {}
#endif
};

void visit(const PaintingValue& painting) {
    for_each_field(Forgetful{}, painting);
}

}  // namespace pastoso::document
