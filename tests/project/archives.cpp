#include "project/archives.hpp"

#include "core/check.hpp"

#include <zip.h>

namespace pastoso::project {

Entries entries_of(std::span<const std::byte> archive) {
    zip_error_t error;
    zip_t* zip = zip_open_from_source(
        zip_source_buffer_create(archive.data(), archive.size(), 0, &error), ZIP_RDONLY, &error);
    PASTOSO_CHECK(zip != nullptr);
    Entries entries;
    for (zip_int64_t i = 0; i < zip_get_num_entries(zip, 0); ++i) {
        zip_stat_t stat;
        zip_stat_index(zip, static_cast<zip_uint64_t>(i), 0, &stat);
        std::string content(stat.size, '\0');
        zip_file_t* file = zip_fopen_index(zip, static_cast<zip_uint64_t>(i), 0);
        zip_fread(file, content.data(), content.size());
        zip_fclose(file);
        entries.emplace_back(stat.name, std::move(content));
    }
    zip_discard(zip);
    return entries;
}

Bytes archive_of(const Entries& entries, bool deflated) {
    zip_error_t error;
    zip_source_t* target = zip_source_buffer_create(nullptr, 0, 0, &error);
    zip_source_keep(target);
    zip_t* zip = zip_open_from_source(target, ZIP_TRUNCATE, &error);
    PASTOSO_CHECK(zip != nullptr);
    for (const auto& [name, content] : entries) {
        const zip_int64_t index =
            zip_file_add(zip, name.c_str(), zip_source_buffer(zip, content.data(), content.size(), 0),
                         ZIP_FL_ENC_UTF_8);
        zip_set_file_compression(zip, static_cast<zip_uint64_t>(index),
                                 deflated ? ZIP_CM_DEFLATE : ZIP_CM_STORE, 0);
    }
    PASTOSO_CHECK(zip_close(zip) == 0);
    zip_stat_t stat;
    zip_source_stat(target, &stat);
    Bytes bytes(stat.size);
    zip_source_open(target);
    zip_source_read(target, bytes.data(), bytes.size());
    zip_source_close(target);
    zip_source_free(target);
    return bytes;
}

Bytes changed(std::span<const std::byte> archive, const std::string& entry,
              const std::function<void(std::string&)>& change) {
    Entries entries = entries_of(archive);
    for (auto& [name, content] : entries)
        if (name == entry) change(content);
    return archive_of(entries);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    PASTOSO_CHECK(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

}  // namespace pastoso::project
