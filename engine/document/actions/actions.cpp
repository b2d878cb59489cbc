#include "document/actions/actions.hpp"

#include "document/actions/field_checks.hpp"

#include <algorithm>

namespace pastoso::document {
namespace {

/// The latest version that a field asks for which is not as in a new action.
template <class Told>
class NewestField {
  public:
    NewestField(const Told& told, int& version) : told_(told), version_(version) {}

    template <class Field>
    void operator()(const Field& field) const {
        if constexpr (requires {
                          field.since;
                          typename Field::At;
                      })
            if (field.since > version_ && Field::At::of(told_) != Field::At::of(fresh_))
                version_ = field.since;
    }
    template <class Place>
    void operator()(const OneOf<Place>&) const {
        std::visit(
            [&]<class Form>(const Form&) {
                if constexpr (requires { Table<Form>::kSince; })
                    version_ = std::max(version_, Table<Form>::kSince);
            },
            Place::of(told_));
    }
    template <class Place>
    void operator()(const Part<Place>&) const {
        const auto& part = Place::of(told_);
        using Kind = std::remove_cvref_t<decltype(part)>;
        Table<Kind>::fields(NewestField<Kind>(part, version_));
    }

  private:
    const Told& told_;
    const Told fresh_{};
    int& version_;
};

}  // namespace

void check_between(const core::Message& name, core::Pattern<0> unit, double value, double low,
                   double high) {
    if (value >= low && value <= high) return;
    if (std::string_view(unit.words()).empty())
        throw core::InputError("the %1 is %2, but must lie between %3 and %4.", name, value, low, high);
    throw core::InputError("the %1 in %2 is %3, but must lie between %4 and %5.", name,
                           core::message(unit), value, low, high);
}

/// What fits, as samples do by the thousand, needs no message.
void check_between(core::Pattern<0> name, core::Pattern<0> unit, double value, double low, double high) {
    if (value >= low && value <= high) return;
    check_between(core::message(name), unit, value, low, high);
}

void check_length(core::Pattern<0> name, const std::string& text, std::size_t most_bytes) {
    if (text.size() <= most_bytes) return;
    throw core::InputError("the %1 has %2 bytes, but at most %3 are kept.", core::message(name),
                           text.size(), most_bytes);
}

UndoRole undo_role(const Action& action) {
    return std::visit([](const auto& told) { return role_of(told); }, action);
}

bool counts_as_change(const Action& action) {
    const auto* pen = std::get_if<PenDown>(&action);
    return traits_of(action).changes_painting && (pen == nullptr || !pen->beside);
}

void check_action(const Action& action) {
    std::visit([](const auto& told) { check_fields(told); }, action);
}

void check_sample(const brush::PenSample& sample) {
    check_fields(sample);
}

int version_needed(const Action& action) {
    return std::visit(
        []<class A>(const A& told) {
            int version = Table<A>::kTraits.since;
            Table<A>::fields(NewestField<A>(told, version));
            return version;
        },
        action);
}

}  // namespace pastoso::document
