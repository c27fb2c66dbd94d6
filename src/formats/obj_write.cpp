#include "formats/obj_write.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/number_text.h"

namespace filigree {
namespace {

constexpr std::uint32_t unwritten = 0;  // numbers in the file begin at 1

std::string number(double value, int decimals) {
    std::string text;
    append_fixed(text, value, decimals);
    return text;
}

std::string name_of(std::string_view text) {
    std::string name;
    for (const char c : text) {
        const bool is_kept = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
                             c == '-' || c == '_' || static_cast<unsigned char>(c) >= 0x80;
        name += is_kept ? c : '_';
    }
    return name;
}

class ObjWriter {
public:
    ObjWriter(const Mesh& mesh, std::span<const Material> materials, const ObjOptions& options)
        : mesh_(mesh), materials_(materials), options_(options), decimals_(std::clamp(options.decimals, 0, 15)) {}

    ObjFiles write() && {
        name_materials();
        obj_ = "mtllib " + name_of(options_.materials_file) + "\n";
        write_points();
        for (std::size_t face = 0; face < mesh_.faces.size(); ++face) {
            read_numbers(corners_of_face(mesh_, face));
            while (numbers_.size() > 1 && numbers_.front() == numbers_.back()) numbers_.pop_back();
            if (numbers_.size() >= 3) write_element("f", mesh_.faces[face].origin);
        }
        for (std::size_t line = 0; line < mesh_.lines.size(); ++line) {
            read_numbers(points_of_line(mesh_, line));
            if (numbers_.size() >= 2) write_element("l", mesh_.lines[line].origin);
        }
        return {std::move(obj_), materials_text()};
    }

private:
    void name_materials() {
        for (const MeshFace& face : mesh_.faces) names_[face.origin.material];
        for (const MeshLine& line : mesh_.lines) names_[line.origin.material];
        std::set<std::string> taken;
        for (auto& [number_of_material, name] : names_) {
            if (number_of_material < materials_.size()) name = name_of(materials_[number_of_material].name);
            if (name.empty()) name = "material-" + to_text(std::uint64_t{number_of_material});
            while (!taken.insert(name).second) name += "-" + to_text(std::uint64_t{number_of_material});
        }
    }

    void write_points() {
        std::vector<char> is_used(mesh_.vertices.size(), 0);
        for (const std::uint32_t corner : mesh_.corners) is_used[corner] = 1;
        for (const std::uint32_t point : mesh_.line_points) is_used[point] = 1;
        number_of_.assign(mesh_.vertices.size(), unwritten);
        std::unordered_map<std::string, std::uint32_t> written;
        for (std::size_t i = 0; i < mesh_.vertices.size(); ++i) {
            if (is_used[i] == 0) continue;
            const Vec3 p = mesh_.vertices[i];
            const std::string text =
                number(p.x, decimals_) + " " + number(p.y, decimals_) + " " + number(p.z, decimals_);
            const auto next = static_cast<std::uint32_t>(written.size() + 1);
            const auto [known, is_new] = written.try_emplace(text, next);
            number_of_[i] = known->second;
            if (is_new) obj_ += "v " + text + "\n";
        }
    }

    // In the file, none twice in a row.
    void read_numbers(std::span<const std::uint32_t> vertices) {
        numbers_.clear();
        for (const std::uint32_t vertex : vertices) {
            if (numbers_.empty() || numbers_.back() != number_of_[vertex]) numbers_.push_back(number_of_[vertex]);
        }
    }

    void write_element(const char* kind, const MeshOrigin& origin) {
        if (!has_group_ || origin.element != element_) {
            const std::string group =
                name_of(options_.group_of ? options_.group_of(origin.element) : to_text(origin.element.value));
            if (!has_group_ || group != group_) obj_ += "g " + group + "\n";
            has_group_ = true;
            element_ = origin.element;
            group_ = group;
        }
        if (!has_material_ || origin.material != material_) {
            obj_ += "usemtl " + names_.at(origin.material) + "\n";
            has_material_ = true;
            material_ = origin.material;
        }
        obj_ += kind;
        for (const std::uint32_t n : numbers_) obj_ += " " + to_text(std::uint64_t{n});
        obj_ += "\n";
    }

    std::string materials_text() const {
        std::string text;
        for (const auto& [i, name] : names_) {
            const Colour fill = i < materials_.size() ? materials_[i].fill : Material{}.fill;
            text += "newmtl " + name + "\nKd";
            for (const std::uint8_t channel : {fill.red, fill.green, fill.blue})
                text += " " + number(channel / 255.0, 4);
            text += "\nd " + number(fill.alpha / 255.0, 4) + "\nillum 1\n";
        }
        return text;
    }

    const Mesh& mesh_;
    const std::span<const Material> materials_;
    const ObjOptions& options_;
    const int decimals_;
    std::string obj_;
    std::map<std::uint32_t, std::string> names_;  // of the materials in use
    std::vector<std::uint32_t> number_of_;        // in the file, of vertices
    std::vector<std::uint32_t> numbers_;
    bool has_group_ = false, has_material_ = false;
    Key element_;
    std::string group_;
    std::uint32_t material_ = 0;
};

}  // namespace

ObjFiles to_obj(const Mesh& mesh, std::span<const Material> materials, const ObjOptions& options) {
    return ObjWriter(mesh, materials, options).write();
}

}  // namespace filigree
