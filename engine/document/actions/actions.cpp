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

  private:
    const Told& told_;
    const Told fresh_{};
    int& version_;
};

}  // namespace

void check_between(std::string_view name, std::string_view unit, double value, double low, double high) {
    if (value >= low && value <= high) return;
    const std::string in_unit = unit.empty() ? "" : " in " + std::string(unit);
    throw core::InputError("the " + std::string(name) + in_unit + " is " + core::number_text(value) +
                           ", but must lie between " + core::number_text(low) + " and " + core::number_text(high) +
                           ".");
}

void check_length(std::string_view name, const std::string& text, std::size_t most_bytes) {
    if (text.size() <= most_bytes) return;
    throw core::InputError("the " + std::string(name) + " has " + std::to_string(text.size()) +
                           " bytes, but at most " + std::to_string(most_bytes) + " are kept.");
}

UndoRole undo_role(const Action& action) {
    return std::visit(
        []<class A>(const A& told) -> UndoRole {
            if constexpr (requires { Table<A>::undo_role(told); })
                return Table<A>::undo_role(told);
            else
                return Table<A>::kTraits.undo;
        },
        action);
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
