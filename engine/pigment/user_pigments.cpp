#include "pigment/user_pigments.hpp"

#include "core/error.hpp"
#include "core/text_file.hpp"
#include "core/user_data.hpp"

#include <algorithm>

namespace pastoso::pigment {
namespace {

constexpr std::size_t kMostBytes = std::size_t{16} << 20;

bool holds(const std::vector<Pigment>& pigments, const std::string& ci_name) {
    return std::any_of(pigments.begin(), pigments.end(),
                       [&](const Pigment& pigment) { return pigment.ci_name == ci_name; });
}

std::vector<Pigment> read_file(const std::filesystem::path& path, const std::vector<Pigment>& taken) {
    std::vector<Pigment> pigments =
        parse_palette(core::read_text_file(path, kMostBytes), bundled_band_weights(), path.string());
    for (const Pigment& pigment : pigments) {
        if (holds(bundled_palette(), pigment.ci_name) || holds(taken, pigment.ci_name)) {
            throw core::InputError("%1: there is already a pigment \"%2\"; give yours another name.",
                                   path.string(), pigment.ci_name);
        }
        if (pigment.ci_name.front() == '#') {
            throw core::InputError("%1: the name \"%2\" begins with #, as only colours do.",
                                   path.string(), pigment.ci_name);
        }
    }
    return pigments;
}

}  // namespace

UserPigments read_user_pigments(const std::filesystem::path& folder) {
    UserPigments user;
    for (const std::filesystem::path& path : core::files_in(folder, ".csv")) {
        try {
            for (Pigment& pigment : read_file(path, user.pigments))
                user.pigments.push_back(std::move(pigment));
        } catch (const core::InputError& fault) {
            user.faults.push_back(fault.message());
        }
    }
    return user;
}

const UserPigments& user_pigments() {
    static const UserPigments user = read_user_pigments(core::user_data_path("pigments"));
    return user;
}

}  // namespace pastoso::pigment
