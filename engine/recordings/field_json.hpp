// Fields of actions and of their parts as JSON, by their tables: what is generic of it. Values with a
// form of their own are in value_json.hpp.
#pragma once

#include "document/actions/table.hpp"
#include "files/json_place.hpp"
#include "recordings/value_json.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace pastoso::recordings {

template <class Told>
files::Json fields_json(const Told& told);
template <class Told>
Told read_fields(const files::JsonPlace& object, ValueReader& values);

/// Puts one field after the other into an object.
template <class Told>
class FieldWriter {
  public:
    FieldWriter(const Told& told, files::Json& json) : told_(told), json_(json) {}

    template <class X, class Y>
    void operator()(const document::Pair<X, Y>& field) const {
        if (is_told(field, X::of(told_), X::of(fresh_)) || is_told(field, Y::of(told_), Y::of(fresh_)))
            json_[field.key] = files::Json::array({X::of(told_), Y::of(told_)});
    }
    template <class Place>
    void operator()(const document::Value<Place>& field) const {
        if (is_told(field, Place::of(told_), Place::of(fresh_)))
            json_[field.key] = value_json(Place::of(told_));
    }
    template <class Place>
    void operator()(const document::OneOf<Place>& field) const {
        std::visit(
            [&]<class Form>(const Form& form) {
                json_[field.key] = document::Table<Form>::kName;
                json_.update(fields_json(form));
            },
            Place::of(told_));
    }
    template <class Place>
    void operator()(const document::Part<Place>&) const {
        json_.update(fields_json(Place::of(told_)));
    }
    /// Numbers, truths and texts.
    template <class Field>
    void operator()(const Field& field) const {
        using At = typename Field::At;
        if (is_told(field, At::of(told_), At::of(fresh_))) json_[field.key] = At::of(told_);
    }

  private:
    template <class Field, class T>
    static bool is_told(const Field& field, const T& value, const T& as_new) {
        return field.presence != document::Presence::Optional || !(value == as_new);
    }

    const Told& told_;
    const Told fresh_{};
    files::Json& json_;
};

/// Gathers the keys that an object may have which tells an action or a part of one.
template <class Told>
class KeyCollector {
  public:
    KeyCollector(const files::JsonPlace& object, std::vector<std::string_view>& keys)
        : object_(object), keys_(keys) {}

    /// Of the forms, only the one that is named.
    template <class Place>
    void operator()(const document::OneOf<Place>& field) const {
        keys_.emplace_back(field.key);
        const auto place = object_.optional_entry(field.key);
        if (!place || !place->value().is_string()) return;
        const auto add_if_named = [&]<class... Forms>(const std::variant<Forms...>&) {
            (add_form<Forms>(place->text()), ...);
        };
        add_if_named(Place::of(fresh_));
    }
    template <class Place>
    void operator()(const document::Part<Place>&) const {
        using Part = std::remove_cvref_t<decltype(Place::of(fresh_))>;
        document::Table<Part>::fields(KeyCollector<Part>(object_, keys_));
    }
    template <class Field>
    void operator()(const Field& field) const {
        keys_.emplace_back(field.key);
    }

  private:
    template <class Form>
    void add_form(const std::string& name) const {
        if (name == document::Table<Form>::kName)
            document::Table<Form>::fields(KeyCollector<Form>(object_, keys_));
    }

    const files::JsonPlace& object_;
    std::vector<std::string_view>& keys_;
    const Told fresh_{};
};

/// Reads one field after the other out of an object.
template <class Told>
class FieldReader {
  public:
    FieldReader(const files::JsonPlace& object, Told& told, ValueReader& values)
        : object_(object), told_(told), values_(values) {}

    template <class Place>
    void operator()(const document::Number<Place>& field) const {
        if (const auto place = found(field)) Place::of(told_) = place->number();
    }
    template <class Place>
    void operator()(const document::Whole<Place>& field) const {
        using Number = std::remove_reference_t<decltype(Place::of(told_))>;
        if (const auto place = found(field))
            Place::of(told_) = static_cast<Number>(place->integer(field.low, field.high));
    }
    template <class X, class Y>
    void operator()(const document::Pair<X, Y>& field) const {
        const auto place = found(field);
        if (!place) return;
        if (place->size() != 2) place->fail("expected two numbers, for example [20, 30].");
        X::of(told_) = place->element(0).number();
        Y::of(told_) = place->element(1).number();
    }
    template <class Place>
    void operator()(const document::Truth<Place>& field) const {
        if (const auto place = found(field)) Place::of(told_) = place->boolean();
    }
    template <class Place>
    void operator()(const document::Text<Place>& field) const {
        if (const auto place = found(field)) Place::of(told_) = place->text();
    }
    template <class Place>
    void operator()(const document::Value<Place>& field) const {
        if (const auto place = found(field)) values_.read(*place, object_, Place::of(told_));
    }
    template <class Place>
    void operator()(const document::OneOf<Place>& field) const {
        read_form(object_.entry(field.key), Place::of(told_));
    }
    template <class Place>
    void operator()(const document::Part<Place>&) const {
        auto& part = Place::of(told_);
        using Part = std::remove_reference_t<decltype(part)>;
        document::Table<Part>::fields(FieldReader<Part>(object_, part, values_));
    }

  private:
    template <class Field>
    std::optional<files::JsonPlace> found(const Field& field) const {
        if (field.presence == document::Presence::Required) return object_.entry(field.key);
        return object_.optional_entry(field.key);
    }

    template <class... Forms>
    void read_form(const files::JsonPlace& place, std::variant<Forms...>& form) const {
        const std::string name = place.text();
        const auto read_if_named = [&]<class Form>(std::type_identity<Form>) {
            if (name != document::Table<Form>::kName) return false;
            Form read{};
            document::Table<Form>::fields(FieldReader<Form>(object_, read, values_));
            form = read;
            return true;
        };
        if ((read_if_named(std::type_identity<Forms>{}) || ...)) return;
        std::string names;
        ((names += (names.empty() ? "" : ", ") + std::string(document::Table<Forms>::kName)), ...);
        place.fail("\"%1\" is not one of %2.", name, names);
    }

    const files::JsonPlace& object_;
    Told& told_;
    ValueReader& values_;
};

template <class Told>
files::Json fields_json(const Told& told) {
    files::Json json = files::Json::object();
    if constexpr (requires { document::Table<Told>::kEmptyIsDefault; })
        if (told == Told{}) return json;
    document::Table<Told>::fields(FieldWriter<Told>(told, json));
    return json;
}

/// Fails at the first entry that is none of the fields.
template <class Told>
Told read_fields(const files::JsonPlace& object, ValueReader& values) {
    std::vector<std::string_view> keys;
    document::Table<Told>::fields(KeyCollector<Told>(object, keys));
    object.allow_only(keys);
    Told told{};
    if constexpr (requires { document::Table<Told>::kEmptyIsDefault; })
        if (object.value().empty()) return told;
    document::Table<Told>::fields(FieldReader<Told>(object, told, values));
    return told;
}

}  // namespace pastoso::recordings
