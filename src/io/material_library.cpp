#define TINYOBJLOADER_IMPLEMENTATION
#include "io/material_library.h"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "io/obj_statements.h"

namespace pectin {
namespace {

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return lower;
}

bool names_texture(std::string_view keyword) {
    const std::string word = lower_case(keyword);
    if (word == "map_aat") return false;  // switches the antialiasing of textures on or off
    return word.starts_with("map_") || word == "bump" || word == "disp" || word == "decal" ||
           word == "refl" || word == "norm";
}

bool is_number(std::string_view word) {
    std::string why_not;
    return parse_number<double>(word, why_not).has_value();
}

bool is_texture_option(std::string_view word) {
    static constexpr auto kOptions = std::to_array<std::string_view>(
        {"-blendu", "-blendv", "-boost", "-bm", "-cc", "-clamp", "-imfchan", "-mm", "-texres",
         "-type", "-o", "-s", "-t", "-colorspace"});
    return std::find(kOptions.begin(), kOptions.end(), word) != kOptions.end();
}

// Rewrites the arguments of a texture statement for the parser. The parser always reads three
// numbers after -o, -s and -t and so takes the name for a number if only one or two are given; the
// missing ones are added. It does not know -cc, which is left out. A number that is the last word
// is a name.
std::string completed_options(std::string_view arguments) {
    std::string result;
    while (true) {
        std::string_view rest = arguments;
        const auto option = take_token(rest);
        if (!option || !is_texture_option(*option)) break;
        if (*option == "-o" || *option == "-s" || *option == "-t") {
            result += std::string(*option) + " ";
            for (int i = 0; i < 3; ++i) {
                std::string_view behind = rest;
                const auto value = take_token(behind);
                const bool is_value = value && is_number(*value) && (i == 0 || !behind.empty());
                result += is_value ? std::string(*value) + " " : *option == "-s" ? "1 " : "0 ";
                if (is_value) rest = behind;
            }
        } else {
            const int values = *option == "-mm" ? 2 : 1;
            const bool is_known = *option != "-cc";
            if (is_known) result += std::string(*option) + " ";
            for (int i = 0; i < values; ++i) {
                const auto value = take_token(rest);
                if (value && is_known) result += std::string(*value) + " ";
            }
        }
        arguments = rest;
    }
    while (!arguments.empty() && is_blank(arguments.front())) arguments.remove_prefix(1);
    return arguments.empty() ? std::string() : result + std::string(arguments);
}

// The slot of the parser that a keyword fills. Several spellings can mean the same slot. In the
// parser, a later statement of a slot replaces an earlier one.
std::string slot_of(std::string_view keyword) {
    const std::string word = lower_case(keyword);
    if (word == "map_bump" || word == "bump") return "bump";
    if (word == "map_disp" || word == "disp") return "disp";
    return word;
}

void add_texture(Material& material, const std::string& name) {
    if (!name.empty()) material.textures.push_back(name);
}

// Takes the textures from the parser's members and from its unknown parameters. The latter, such as
// decal and map_opacity, still have options before the name.
void take_textures(const tinyobj::material_t& parsed, Material& material) {
    using tinyobj::material_t;
    constexpr std::array kNames{
        &material_t::ambient_texname,   &material_t::diffuse_texname,
        &material_t::specular_texname,  &material_t::specular_highlight_texname,
        &material_t::bump_texname,      &material_t::displacement_texname,
        &material_t::alpha_texname,     &material_t::reflection_texname,
        &material_t::roughness_texname, &material_t::metallic_texname,
        &material_t::sheen_texname,     &material_t::emissive_texname,
        &material_t::normal_texname};
    for (const auto name : kNames) add_texture(material, parsed.*name);
    for (const auto& [keyword, value] : parsed.unknown_parameter) {
        if (!names_texture(keyword)) continue;
        std::string name;
        tinyobj::texture_option_t options{};
        if (tinyobj::ParseTextureNameAndOption(&name, &options, value.c_str())) {
            add_texture(material, name);
        }
    }
}

// Collects the statements of a material and parses them in pieces. The parser keeps one value per
// slot, so each piece contains a slot at most once.
class MaterialReader {
  public:
    void read(std::string_view keyword, std::string_view arguments);
    std::vector<Material> take() {
        end_material();
        return std::move(materials_);
    }

  private:
    void parse_piece();
    void end_material();

    std::vector<Material> materials_;
    Material material_;
    bool has_begun_ = false;  // by newmtl or by a statement before the first newmtl
    std::string piece_;
    std::set<std::string> slots_;  // in piece_
};

void MaterialReader::read(std::string_view keyword, std::string_view arguments) {
    if (keyword == "newmtl") {
        end_material();
        material_.name = arguments;
        has_begun_ = true;
        return;
    }
    has_begun_ = true;
    const bool is_texture = names_texture(keyword);
    // The parser reads lines up to the first zero byte, which would shorten the name. No file has
    // such a name.
    if (is_texture && arguments.find('\0') != arguments.npos) {
        return add_texture(material_, std::string(arguments));
    }
    const std::string value = is_texture ? completed_options(arguments) : std::string(arguments);
    if (value.empty()) return;
    if (!slots_.insert(slot_of(keyword)).second) {
        parse_piece();
        slots_.insert(slot_of(keyword));
    }
    piece_.append(keyword).append(" ").append(value).append("\n");
}

void MaterialReader::parse_piece() {
    // The parser drops statements before the first newmtl, so every piece gets one. The name of
    // the material is not needed here.
    std::istringstream stream("newmtl m\n" + std::exchange(piece_, {}));
    slots_.clear();
    std::map<std::string, int> names;
    std::vector<tinyobj::material_t> parsed;
    std::string warning, error;
    tinyobj::LoadMtl(&names, &parsed, &stream, &warning, &error);
    for (const tinyobj::material_t& one : parsed) take_textures(one, material_);
}

void MaterialReader::end_material() {
    if (!piece_.empty()) parse_piece();
    if (has_begun_) materials_.push_back(std::exchange(material_, {}));
    has_begun_ = false;
}

}  // namespace

std::vector<Material> parse_materials(std::string_view text, const Progress& progress) {
    MaterialReader reader;
    ObjStatements statements(text);
    constexpr std::size_t kStatementsBetweenChecks = 256;
    for (std::size_t i = 0; statements.next(); ++i) {
        if (i % kStatementsBetweenChecks == 0) progress.advance(0.0);
        reader.read(statements.keyword(), statements.arguments());
    }
    return reader.take();
}

bool may_be_material_library(std::string_view text) {
    static constexpr auto kKeywords = std::to_array<std::string_view>(
        {"newmtl", "ka",  "kd",    "ks",     "ke",        "kt",  "tf",      "tr",
         "d",      "ns",  "ni",    "illum",  "sharpness", "pr",  "pm",      "ps",
         "pc",     "pcr", "aniso", "anisor", "map_aat",   "xyz", "spectral"});
    if (text.starts_with("#!")) return false;
    std::size_t known = 0, unknown = 0;
    bool has_begun = false;
    ObjStatements statements(text);
    while (statements.next()) {
        const std::string word = lower_case(statements.keyword());
        const bool is_known = names_texture(word) || std::find(kKeywords.begin(), kKeywords.end(),
                                                               word) != kKeywords.end();
        has_begun = has_begun || word == "newmtl";
        if (!is_known && !has_begun) return false;
        ++(is_known ? known : unknown);
    }
    return known >= unknown;
}

}  // namespace pectin
