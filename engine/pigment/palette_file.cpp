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

std::string in_quotes(std::string_view text) {
    return "\"" + std::string(text) + "\"";
}

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

core::InputError error_at(const Line& line, std::size_t column, const std::string& message) {
    return core::located_error(
        line.file, line.number,
        "column " + std::to_string(column + 1) + " (" + heading_of(column) + "): " + message);
}

void check_column_count(const Line& line) {
    const std::size_t count = line.fields.size();
    if (count == kColumns) return;
    const std::string found =
        "there are " + std::to_string(count) + " columns instead of " + std::to_string(kColumns) + ".";
    if (count < kColumns) throw error_at(line, count, "missing; " + found);
    throw core::located_error(line.file, line.number, found);
}

void check_heading(const Line& line) {
    check_column_count(line);
    for (std::size_t column = 0; column < kColumns; ++column) {
        if (line.fields[column] == heading_of(column)) continue;
        throw error_at(line, column,
                       "the heading is " + in_quotes(line.fields[column]) + " instead of " +
                           in_quotes(heading_of(column)) + ".");
    }
}

double parse_coefficient(const Line& line, std::size_t column) {
    const std::string_view text = line.fields[column];
    double value = 0.0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (status != std::errc{} || end != text.data() + text.size()) {
        throw error_at(line, column, in_quotes(text) + " is not a number.");
    }
    if (!std::isfinite(value))
        throw error_at(line, column, in_quotes(text) + " is not a finite number.");
    if (value < 0.0) throw error_at(line, column, std::string(text) + " per mm is negative.");
    return value;
}

Row parse_row(const Line& line) {
    check_column_count(line);
    Row row{line.fields[0], line.fields[1], line.fields[2] == "K", {}};
    if (row.ci_name.empty()) throw error_at(line, 0, "the pigment has no name.");
    if (line.fields[2] != "K" && line.fields[2] != "S") {
        throw error_at(line, 2, in_quotes(line.fields[2]) + " is neither K nor S.");
    }
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
        throw core::located_error(line.file, line.number,
                                  std::string(row.absorption ? "K" : "S") + " of the pigment " +
                                      in_quotes(row.ci_name) + " is given twice.");
    }
    seen = true;
    (row.absorption ? entry.pigment.absorption_per_mm : entry.pigment.scattering_per_mm) = row.values;
}

void check_strength(const Pigment& pigment, const std::string& file) {
    for (int channel = 0; channel < kChannels; ++channel) {
        const float value = pigment.coefficients[channel];
        if (value <= kMostPerMm) continue;
        throw core::InputError(file + ": " + (channel < kBands ? "K" : "S") + " of the pigment " +
                               in_quotes(pigment.ci_name) + " is " + std::to_string(value) +
                               " per mm in band " + std::to_string(channel % kBands + 1) + " of " +
                               std::to_string(kBands) + ", above the " + std::to_string(kMostPerMm) +
                               " that paint can have; give the pigment in a weaker paint.");
    }
}

Pigment completed(Entry entry, const BandWeights& weights, const std::string& file) {
    if (!entry.has_absorption || !entry.has_scattering) {
        throw core::InputError(file + ": the pigment " + in_quotes(entry.pigment.ci_name) +
                               " has no line for " + (entry.has_absorption ? "S." : "K."));
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
    if (entries.empty()) throw core::InputError(name + ": there is no pigment in this file.");
    std::vector<Pigment> palette;
    for (Entry& entry : entries)
        palette.push_back(completed(std::move(entry), weights, name));
    return palette;
}

}  // namespace pastoso::pigment
