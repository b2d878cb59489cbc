#include "recordings/action_table.hpp"

#include "core/number_text.hpp"
#include "document/actions/actions.hpp"

#include <set>
#include <string_view>
#include <type_traits>
#include <variant>

namespace pastoso::recordings {
namespace {

using document::Presence;
using document::Table;

/// The rows of the fields of an action or of a part of one.
template <class Told>
class FieldRows {
  public:
    explicit FieldRows(std::string& rows) : rows_(rows) {}

    template <class Place>
    void operator()(const document::Number<Place>& field) const {
        add(field, between(field.low, field.high, field.unit.words()),
            core::number_text(Place::of(fresh_)));
    }
    template <class Place>
    void operator()(const document::Whole<Place>& field) const {
        const std::string range =
            "whole, " + between(static_cast<double>(field.low), static_cast<double>(field.high), "");
        add(field, range, std::to_string(Place::of(fresh_)));
    }
    template <class X, class Y>
    void operator()(const document::Pair<X, Y>& field) const {
        add(field, "`[x, y]`, " + between(field.low, field.high, field.unit.words()),
            "`[" + core::number_text(X::of(fresh_)) + ", " + core::number_text(Y::of(fresh_)) + "]`");
    }
    template <class Place>
    void operator()(const document::Truth<Place>& field) const {
        add(field, "`true`, `false`", Place::of(fresh_) ? "`true`" : "`false`");
    }
    template <class Place>
    void operator()(const document::Text<Place>& field) const {
        add(field, "text, at most " + std::to_string(field.most_bytes) + " bytes", "");
    }
    template <class Place>
    void operator()(const document::Value<Place>& field) const {
        add(field, "", "");
    }
    template <class Place>
    void operator()(const document::OneOf<Place>& field) const {
        add_forms(field, Place::of(fresh_));
    }
    template <class Place>
    void operator()(const document::Part<Place>&) const {
        Table<std::remove_cvref_t<decltype(Place::of(fresh_))>>::fields(
            FieldRows<std::remove_cvref_t<decltype(Place::of(fresh_))>>(rows_));
    }

  private:
    static std::string between(double low, double high, std::string_view unit) {
        const std::string range = core::number_text(low) + " to " + core::number_text(high);
        return unit.empty() ? range : range + " " + std::string(unit);
    }
    template <class Field>
    void add(const Field& field, const std::string& range, const std::string& as_new) const {
        const std::string shown = field.presence == Presence::Required ? "required" : as_new;
        add_row(field.key, range, shown, field.since, words_of(field.name), field.note);
    }
    static std::string_view words_of(std::string_view name) { return name; }
    static std::string_view words_of(core::Pattern<0> name) { return name.words(); }
    void add_row(const char* key, const std::string& range, const std::string& as_new, int since,
                 std::string_view name, std::string_view note) const {
        rows_ += "| `" + std::string(key) + "` | " + range + " | " + as_new + " | " +
                 (since > 1 ? std::to_string(since) : "") + " | " + std::string(name) +
                 (note.empty() ? "" : "; " + std::string(note)) + " |\n";
    }
    template <class Field, class... Forms>
    void add_forms(const Field& field, const std::variant<Forms...>&) const {
        std::string names;
        ((names += (names.empty() ? "`\"" : ", `\"") + std::string(Table<Forms>::kName) + "\"`"), ...);
        add_row(field.key, names, "required", field.since, field.name, field.note);
        (Table<Forms>::fields(FieldRows<Forms>(rows_)), ...);
    }

    std::string& rows_;
    const Told fresh_{};
};

/// The keys of the fields of an action or of a part of one.
template <class Told>
class FieldKeys {
  public:
    explicit FieldKeys(std::set<std::string>& keys) : keys_(keys) {}

    template <class Place>
    void operator()(const document::OneOf<Place>& field) const {
        keys_.insert(field.key);
        add_forms(Place::of(fresh_));
    }
    template <class Place>
    void operator()(const document::Part<Place>&) const {
        using Part = std::remove_cvref_t<decltype(Place::of(fresh_))>;
        Table<Part>::fields(FieldKeys<Part>(keys_));
    }
    template <class Field>
    void operator()(const Field& field) const {
        keys_.insert(field.key);
    }

  private:
    template <class... Forms>
    void add_forms(const std::variant<Forms...>&) const {
        (keys_.insert(std::string(Table<Forms>::kName)), ...);
        (Table<Forms>::fields(FieldKeys<Forms>(keys_)), ...);
    }

    std::set<std::string>& keys_;
    const Told fresh_{};
};

}  // namespace

std::string action_table() {
    std::string rows =
        "| entry | what it can be | default | since | meaning |\n| --- | --- | --- | --- | --- |\n";
    document::AllActions::for_each([&]<class A>(std::type_identity<A>) {
        const document::ActionTraits& traits = Table<A>::kTraits;
        if (std::string_view(traits.key) == "stroke") return;
        rows += "| **`" + std::string(traits.key.value) + "`** | | | " + std::to_string(traits.since) +
                " | " + std::string(traits.meaning.value) + " |\n";
        Table<A>::fields(FieldRows<A>(rows));
    });
    return rows;
}

std::string action_dictionary() {
    std::set<std::string> keys;
    document::AllActions::for_each([&]<class A>(std::type_identity<A>) {
        keys.insert(Table<A>::kTraits.key.value);
        Table<A>::fields(FieldKeys<A>(keys));
    });
    std::string lines = "# Keys of recordings (write_action_table --dictionary).\n";
    for (const std::string& key : keys)
        lines += "\"\\\"" + key + "\\\"\"\n";
    return lines;
}

}  // namespace pastoso::recordings
