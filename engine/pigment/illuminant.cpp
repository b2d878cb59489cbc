#include "pigment/illuminant.hpp"

#include "core/error.hpp"
#include "core/looking.hpp"
#include "core/resources.hpp"
#include "core/text.hpp"
#include "core/text_file.hpp"
#include "pigment/adaptation.hpp"
#include "pigment/observer.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <vector>

namespace pastoso::pigment {
namespace {

constexpr double kCoveredFrom_nm = 400.0;
constexpr double kCoveredTo_nm = 700.0;

/// A light whose white excites one kind of cone less than this, in parts of what D65 does, is a pure
/// colour. Illuminant A has 0.36 in the blue, candles 0.2.
constexpr double kFaintestCone = 0.01;

struct Reading {
    double wavelength_nm = 0.0, power = 0.0;
};

/// A line of the file, for errors.
struct Line {
    const std::string& file;
    long number = 0;
    std::string_view text;
};

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::optional<double> number_in(std::string_view text) {
    double value = 0.0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (status != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

double parse_number(const Line& line, std::string_view text, const core::Message& what) {
    const std::optional<double> value = number_in(text);
    if (!value || !std::isfinite(*value)) {
        throw core::located_error(line.file, line.number, "%1 \"%2\" is not a finite number.", what,
                                  text);
    }
    return *value;
}

Reading parse_reading(const Line& line) {
    const std::size_t comma = line.text.find(',');
    if (comma == std::string_view::npos || line.text.find(',', comma + 1) != std::string_view::npos) {
        throw core::located_error(line.file, line.number,
                                  "\"%1\" is not a wavelength in nm and a power with one comma.",
                                  line.text);
    }
    const std::string_view power = trimmed(line.text.substr(comma + 1));
    const Reading reading{
        parse_number(line, trimmed(line.text.substr(0, comma)), core::message("the wavelength")),
        parse_number(line, power, core::message("the power"))};
    if (reading.power < 0.0)
        throw core::located_error(line.file, line.number, "the power %1 is negative.", power);
    return reading;
}

/// Whether the line is the heading: its first column is no number.
bool is_heading(std::string_view text) {
    const std::size_t comma = text.find(',');
    return comma != std::string_view::npos && trimmed(text.substr(0, comma)) == "wavelength_nm";
}

void add_reading(std::vector<Reading>& readings, const Line& line) {
    const Reading reading = parse_reading(line);
    if (!readings.empty() && reading.wavelength_nm <= readings.back().wavelength_nm) {
        throw core::located_error(line.file, line.number,
                                  "the wavelength %1 nm is not greater than that of the line before.",
                                  line.text.substr(0, line.text.find(',')));
    }
    readings.push_back(reading);
}

std::vector<Reading> parse_readings(std::string_view csv_text, const std::string& name) {
    std::vector<Reading> readings;
    bool first = true;
    long number = 0;
    for (std::size_t begin = 0; begin < csv_text.size();) {
        const std::size_t end = std::min(csv_text.find('\n', begin), csv_text.size());
        const Line line{name, ++number, trimmed(csv_text.substr(begin, end - begin))};
        begin = end + 1;
        if (line.text.empty() || line.text.front() == '#') continue;
        if (!(first && is_heading(line.text))) add_reading(readings, line);
        first = false;
    }
    return readings;
}

void check_range(const std::vector<Reading>& readings, const std::string& name) {
    if (readings.empty())
        throw core::InputError("%1: there is no reading of a light in this file.", name);
    const Reading &first = readings.front(), &last = readings.back();
    if (first.wavelength_nm <= kCoveredFrom_nm && last.wavelength_nm >= kCoveredTo_nm) return;
    throw core::InputError("%1: the readings go from %2 to %3 nm; a light is needed from 400 to 700 nm.",
                           name, std::lround(first.wavelength_nm), std::lround(last.wavelength_nm));
}

double interpolated(const std::vector<Reading>& readings, double wavelength_nm) {
    const auto after = std::find_if(readings.begin(), readings.end(), [&](const Reading& reading) {
        return reading.wavelength_nm >= wavelength_nm;
    });
    if (after == readings.begin()) return readings.front().power;
    if (after == readings.end()) return readings.back().power;
    const Reading& before = *(after - 1);
    const double share =
        (wavelength_nm - before.wavelength_nm) / (after->wavelength_nm - before.wavelength_nm);
    return before.power + share * (after->power - before.power);
}

double sample_at(const std::vector<Reading>& readings, double wavelength_nm) {
    double sum = 0.0, weights = 0.0;
    int near = 0;
    for (std::size_t i = 0; i < readings.size(); ++i) {
        const double distance = std::abs(readings[i].wavelength_nm - wavelength_nm) / kWavelengthStep_nm;
        if (distance >= 1.0) continue;
        const double low = readings[i > 0 ? i - 1 : i].wavelength_nm;
        const double high = readings[std::min(i + 1, readings.size() - 1)].wavelength_nm;
        const double weight = (1.0 - distance) * (high - low);
        sum += weight * readings[i].power;
        weights += weight;
        ++near;
    }
    return near > 2 ? sum / weights : interpolated(readings, wavelength_nm);
}

void check_white(const Illuminant& light) {
    double seen = 0.0;
    for (int i = 0; i < kSpectralSamples; ++i)
        seen += light.power[i] * kColourMatchingY[i];
    if (!(seen > 0.0)) throw core::InputError("%1: this light has no power that is seen.", light.name);
    const Vector3 cones = cones_of(white_under(light.power)), usual = cones_of(white_xyz(kD65White));
    for (int i = 0; i < 3; ++i) {
        if (cones[i] >= kFaintestCone * usual[i]) continue;
        throw core::InputError(
            "%1: this light is so nearly a pure colour that nothing looks white in it.", light.name);
    }
}

}  // namespace

Illuminant parse_illuminant(std::string_view csv_text, const std::string& name) {
    const std::vector<Reading> readings = parse_readings(csv_text, name);
    check_range(readings, name);
    Illuminant light{name, {}};
    for (int i = 0; i < kSpectralSamples; ++i)
        light.power[i] = sample_at(readings, kFirstWavelength_nm + kWavelengthStep_nm * i);
    check_white(light);
    return light;
}

Illuminant find_illuminant(const std::string& name_or_path) {
    for (const char* name : kBundledIlluminants) {
        if (core::lower_case(name) != core::lower_case(name_or_path)) continue;
        const auto path = core::resource_path(std::string("illuminants/") + name + ".csv");
        Illuminant light = parse_illuminant(core::read_text_file(path), path.string());
        light.name = name;
        return light;
    }
    if (name_or_path.find_first_of("./") == std::string::npos &&
        !core::is_there(name_or_path)) {
        throw core::InputError(
            "There is no light \"%1\"; there are D65, D50, A and LED, or give the path of a CSV file.",
            name_or_path);
    }
    return parse_illuminant(core::read_text_file(name_or_path), name_or_path);
}

}  // namespace pastoso::pigment
