#include "pigment/palette.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "core/resources.hpp"
#include "core/text.hpp"
#include "core/text_file.hpp"
#include "pigment/user_pigments.hpp"

#include <algorithm>
#include <numeric>

namespace pastoso::pigment {
namespace {

BandWeights load_band_weights() {
    const auto path = core::resource_path("pigments/bands_6.json");
    return parse_band_weights(core::read_text_file(path), path.string());
}

std::vector<Pigment> load_bundled_palette() {
    const auto path = core::resource_path("pigments/pigments.csv");
    return parse_palette(core::read_text_file(path), bundled_band_weights(), path.string());
}

/// The pigment of that name, or nothing.
const Pigment* find_in(const std::vector<Pigment>& palette, std::string_view ci_name) {
    const auto found = std::find_if(palette.begin(), palette.end(),
                                    [&](const Pigment& pigment) { return pigment.ci_name == ci_name; });
    return found == palette.end() ? nullptr : &*found;
}

/// The number of letters to insert, drop or change that turn one text into the other (Levenshtein).
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t changed = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({changed, row[j] + 1, row[j - 1] + 1});
        }
    }
    return row.back();
}

bool resembles(const Pigment& pigment, const std::string& wanted) {
    if (wanted.size() >= 3 && core::lower_case(pigment.name).find(wanted) != std::string::npos)
        return true;
    return edit_distance(core::lower_case(pigment.ci_name), wanted) <= 1;
}

/// "NAME or NAME"; empty where none resembles what was wanted.
core::Message suggestions(std::string_view wanted) {
    core::Message names;
    for (const std::vector<Pigment>* palette : {&bundled_palette(), &user_pigments().pigments}) {
        for (const Pigment& pigment : *palette) {
            if (!resembles(pigment, core::lower_case(wanted))) continue;
            const std::string name = pigment.ci_name + " (" + pigment.name + ")";
            names =
                names.empty() ? core::Message::verbatim(name) : core::message("%1 or %2", names, name);
        }
    }
    return names;
}

std::string names_of(const std::vector<Pigment>& palette) {
    std::string names;
    for (const Pigment& pigment : palette)
        names += (names.empty() ? "" : ", ") + pigment.ci_name;
    return names;
}

/// Which pigments there are, the user's own as well, and which of those could not be read.
core::Message all_names() {
    const UserPigments& user = user_pigments();
    const std::string names = names_of(bundled_palette());
    core::Message all = user.pigments.empty() ? core::message("the palette has %1.", names)
                                              : core::message("the palette has %1, yours %2.", names,
                                                              names_of(user.pigments));
    for (const core::Message& fault : user.faults)
        all = core::message("%1 Not read: %2", all, fault);
    return all;
}

}  // namespace

const BandWeights& bundled_band_weights() {
    static const BandWeights weights = load_band_weights();
    return weights;
}

const std::vector<Pigment>& bundled_palette() {
    static const std::vector<Pigment> palette = load_bundled_palette();
    return palette;
}

const Pigment& find_pigment(std::string_view ci_name) {
    if (const Pigment* pigment = find_in(bundled_palette(), ci_name)) return *pigment;
    if (const Pigment* pigment = find_in(user_pigments().pigments, ci_name)) return *pigment;
    const core::Message meant = suggestions(ci_name);
    if (meant.empty()) throw core::InputError("There is no pigment \"%1\"; %2", ci_name, all_names());
    throw core::InputError("There is no pigment \"%1\"; did you mean %2; %3", ci_name, meant,
                           all_names());
}

Coefficients mix(std::span<const Portion> portions) {
    std::array<double, kChannels> sum{};
    double parts = 0.0;
    for (const Portion& portion : portions) {
        PASTOSO_CHECK_OP(portion.parts, >=, 0.0);
        parts += portion.parts;
        for (int k = 0; k < kChannels; ++k)
            sum[k] += portion.parts * portion.coefficients[k];
    }
    PASTOSO_CHECK_OP(parts, >, 0.0);
    Coefficients mixture{};
    for (int k = 0; k < kChannels; ++k)
        mixture[k] = static_cast<float>(sum[k] / parts);
    return mixture;
}

}  // namespace pastoso::pigment
