// Whether what an action says lies within the ranges of its table.
#pragma once

#include "core/error.hpp"
#include "document/actions/table.hpp"

#include <string>
#include <type_traits>
#include <variant>

namespace pastoso::document {

/// Throws InputError "the NAME in UNIT is V, but must lie between A and B."; of a pure number, with the
/// unit "", "the NAME is V, but ...".
void check_between(const core::Message& name, core::Pattern<0> unit, double value, double low,
                   double high);
void check_between(core::Pattern<0> name, core::Pattern<0> unit, double value, double low, double high);

/// Throws InputError when there are more than `most_bytes`.
void check_length(core::Pattern<0> name, const std::string& text, std::size_t most_bytes);

template <class Told>
void check_fields(const Told& told);

/// Checks one field after the other of an action or a part of one.
template <class Told>
class FieldChecker {
  public:
    explicit FieldChecker(const Told& told) : told_(told) {}

    template <class Place>
    void operator()(const Number<Place>& field) const {
        check_number(field, Place::of(told_), Place::of(fresh_));
    }
    template <class Place>
    void operator()(const Whole<Place>& field) const {
        if (Place::of(told_) == Place::of(fresh_) && field.presence == Presence::Optional) return;
        check_between(field.name, "", static_cast<double>(Place::of(told_)),
                      static_cast<double>(field.low), static_cast<double>(field.high));
    }
    template <class X, class Y>
    void operator()(const Pair<X, Y>& field) const {
        const core::Message name = core::message(field.name);
        check_between(core::message("x of the %1", name), field.unit, X::of(told_), field.low,
                      field.high);
        check_between(core::message("y of the %1", name), field.unit, Y::of(told_), field.low,
                      field.high);
    }
    template <class Place>
    void operator()(const Truth<Place>&) const {}
    template <class Place>
    void operator()(const Text<Place>& field) const {
        check_length(field.name, Place::of(told_), field.most_bytes);
    }
    template <class Place>
    void operator()(const Value<Place>&) const {}
    template <class Place>
    void operator()(const OneOf<Place>&) const {
        std::visit([](const auto& alternative) { check_fields(alternative); }, Place::of(told_));
    }
    template <class Place>
    void operator()(const Part<Place>&) const {
        check_fields(Place::of(told_));
    }

  private:
    template <class Field>
    static void check_number(const Field& field, double value, double as_new) {
        if (value == as_new && field.presence == Presence::Optional) return;
        check_between(field.name, field.unit, value, field.low, field.high);
    }

    const Told& told_;
    const Told fresh_{};
};

/// Throws InputError for a field out of range, or for fields that do not fit together (check_whole()).
template <class Told>
void check_fields(const Told& told) {
    if constexpr (requires { Table<Told>::kEmptyIsDefault; })
        if (told == Told{}) return;
    Table<Told>::fields(FieldChecker<Told>(told));
    if constexpr (requires { check_whole(told); }) check_whole(told);
}

}  // namespace pastoso::document
