#include "core/error.hpp"
#include "pigment/palette.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace pastoso::pigment {
namespace {

constexpr std::size_t kLabelColumns = 3;  // ci_name, name, coef
constexpr std::size_t kColumns = kLabelColumns + kSpectralSamples;

struct Line {
    const std::string& file;
    long number = 0;
    std::vector<std::string_view> fields;
};

struct Row {
    std::string_view ci_name, name;
    bool absorption = true;
    Spectrum values{};
};

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(separator, begin), text.size());
        parts.push_back(trimmed(text.substr(begin, end - begin)));
        begin = end + 1;
    }
    return parts;
}

std::string heading_of(std::size_t column) {
    static constexpr const char* kLabels[kLabelColumns] = {"ci_name", "name", "coef"};
    if (column < kLabelColumns) return kLabels[column];
    const auto sample = static_cast<int>(column - kLabelColumns);
    return std::to_string(kFirstWavelength_nm + kWavelengthStep_nm * sample);
}

template <class... Arguments>
core::InputError error_at(const Line& line, std::size_t column,
                          core::Pattern<sizeof...(Arguments)> pattern, const Arguments&... arguments) {
    return core::located_error(line.file, line.number, "column %1 (%2): %3", column + 1,
                               heading_of(column), core::message(pattern, arguments...));
}

void check_column_count(const Line& line) {
    const std::size_t count = line.fields.size();
    if (count == kColumns) return;
    const core::Message found = core::message("there are %1 columns instead of %2.", count, kColumns);
    if (count < kColumns) throw error_at(line, count, "missing; %1", found);
    throw core::located_error(line.file, line.number, found);
}

void check_heading(const Line& line) {
    check_column_count(line);
    for (std::size_t column = 0; column < kColumns; ++column) {
        if (line.fields[column] == heading_of(column)) continue;
        throw error_at(line, column, "the heading is \"%1\" instead of \"%2\".", line.fields[column],
                       heading_of(column));
    }
}

double parse_coefficient(const Line& line, std::size_t column) {
    const std::string_view text = line.fields[column];
    double value = 0.0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (status != std::errc{} || end != text.data() + text.size())
        throw error_at(line, column, "\"%1\" is not a number.", text);
    if (!std::isfinite(value)) throw error_at(line, column, "\"%1\" is not a finite number.", text);
    if (value < 0.0) throw error_at(line, column, "%1 per mm is negative.", text);
    return value;
}

Row parse_row(const Line& line) {
    check_column_count(line);
    Row row{line.fields[0], line.fields[1], line.fields[2] == "K", {}};
    if (row.ci_name.empty()) throw error_at(line, 0, "the pigment has no name.");
    if (line.fields[2] != "K" && line.fields[2] != "S")
        throw error_at(line, 2, "\"%1\" is neither K nor S.", line.fields[2]);
    for (int i = 0; i < kSpectralSamples; ++i)
        row.values[i] = parse_coefficient(line, kLabelColumns + i);
    return row;
}

/// A pigment and which of its two lines have been read.
struct Entry {
    Pigment pigment;
    bool has_absorption = false, has_scattering = false;
};

Entry& entry_of(std::vector<Entry>& entries, const Row& row) {
    const auto found = std::find_if(entries.begin(), entries.end(), [&](const Entry& entry) {
        return entry.pigment.ci_name == row.ci_name;
    });
    if (found != entries.end()) return *found;
    entries.emplace_back();
    entries.back().pigment.ci_name = row.ci_name;
    entries.back().pigment.name = row.name;
    return entries.back();
}

void add_row(std::vector<Entry>& entries, const Row& row, const Line& line) {
    Entry& entry = entry_of(entries, row);
    bool& seen = row.absorption ? entry.has_absorption : entry.has_scattering;
    if (seen) {
        throw core::located_error(line.file, line.number, "%1 of the pigment \"%2\" is given twice.",
                                  row.absorption ? "K" : "S", row.ci_name);
    }
    seen = true;
    (row.absorption ? entry.pigment.absorption_per_mm : entry.pigment.scattering_per_mm) = row.values;
}

void check_strength(const Pigment& pigment, const std::string& file) {
    for (int channel = 0; channel < kChannels; ++channel) {
        const float value = pigment.coefficients[channel];
        if (value <= kMostPerMm) continue;
        throw core::InputError(
            "%1: %2 of the pigment \"%3\" is %4 per mm in band %5 of %6, above the %7 that paint can "
            "have; give the pigment in a weaker paint.",
            file, channel < kBands ? "K" : "S", pigment.ci_name, std::to_string(value),
            channel % kBands + 1, kBands, std::to_string(kMostPerMm));
    }
}

Pigment completed(Entry entry, const BandWeights& weights, const std::string& file) {
    if (!entry.has_absorption || !entry.has_scattering) {
        throw core::InputError("%1: the pigment \"%2\" has no line for %3.", file, entry.pigment.ci_name,
                               entry.has_absorption ? "S" : "K");
    }
    const Bands absorption = reduce_to_bands(entry.pigment.absorption_per_mm, weights);
    const Bands scattering = reduce_to_bands(entry.pigment.scattering_per_mm, weights);
    std::copy(absorption.begin(), absorption.end(), entry.pigment.coefficients.begin());
    std::copy(scattering.begin(), scattering.end(), entry.pigment.coefficients.begin() + kBands);
    check_strength(entry.pigment, file);
    return std::move(entry.pigment);
}

}  // namespace

std::vector<Pigment> parse_palette(std::string_view csv_text, const BandWeights& weights,
                                   const std::string& name) {
    std::vector<Entry> entries;
    bool heading_seen = false;
    long number = 0;
    for (const std::string_view text : split(csv_text, '\n')) {
        ++number;
        if (text.empty() || text.front() == '#') continue;
        const Line line{name, number, split(text, ',')};
        if (heading_seen) {
            add_row(entries, parse_row(line), line);
        } else {
            check_heading(line);
            heading_seen = true;
        }
    }
    if (entries.empty()) throw core::InputError("%1: there is no pigment in this file.", name);
    std::vector<Pigment> palette;
    for (Entry& entry : entries)
        palette.push_back(completed(std::move(entry), weights, name));
    return palette;
}

}  // namespace pastoso::pigment
