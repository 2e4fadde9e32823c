#include "io/model_format.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>

#include "io/file_error.h"
#include "io/obj_reader.h"
#include "io/obj_writer.h"

namespace pectin {
namespace {

constexpr std::array kFormats{ModelFormat{"OBJ", ".obj", read_obj, write_obj}};

static_assert(kFormats.front().write != nullptr);

template <class Accepts>
std::vector<std::string> extensions(const Accepts& accepts) {
    std::vector<std::string> accepted;
    for (const ModelFormat& format : kFormats) {
        if (accepts(format)) accepted.emplace_back(format.extension);
    }
    return accepted;
}

const ModelFormat* format_of(const std::string& path) {
    const auto format = std::find_if(
        kFormats.begin(), kFormats.end(),
        [&path](const ModelFormat& known) { return has_extension(path, known.extension); });
    return format == kFormats.end() ? nullptr : &*format;
}

// "does not end in .obj; save writes OBJ files"
std::string refusal_to_write() {
    std::string extensions, names;
    for (const ModelFormat& format : kFormats) {
        if (format.write == nullptr) continue;
        const char* const separator = names.empty() ? "" : " or ";
        extensions.append(separator).append(format.extension);
        names.append(separator).append(format.name);
    }
    return "does not end in " + extensions + "; save writes " + names + " files";
}

}  // namespace

std::span<const ModelFormat> model_formats() { return kFormats; }

std::vector<std::string> readable_extensions() {
    return extensions([](const ModelFormat&) { return true; });
}

std::vector<std::string> writable_extensions() {
    return extensions([](const ModelFormat& format) { return format.write != nullptr; });
}

bool has_writable_format(const std::string& path) {
    const ModelFormat* const format = format_of(path);
    return format && format->write != nullptr;
}

bool has_extension(std::string_view path, std::string_view extension) {
    if (path.size() < extension.size()) return false;
    return std::equal(
        extension.begin(), extension.end(),
        path.end() - static_cast<std::ptrdiff_t>(extension.size()),
        [](char y, char x) { return std::tolower(static_cast<unsigned char>(x)) == y; });
}

const ModelFormat& format_for_reading(const std::string& path) {
    const ModelFormat* const format = format_of(path);
    return format ? *format : kFormats.front();
}

IndexedFaceSet read_model(const std::string& path, const Progress& progress, ReadReport* report) {
    return format_for_reading(path).read(path, progress, report);
}

void write_model(const TriMesh& mesh, const std::string& path, const Progress& progress) {
    if (!has_writable_format(path)) throw FileError(path, refusal_to_write());
    format_of(path)->write(mesh, path, progress);
}

}  // namespace pectin
