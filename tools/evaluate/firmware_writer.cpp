#include "evaluate/firmware_writer.hpp"

#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <vector>

#include "bake/image_bytes.hpp"
#include "evaluate/setups.hpp"
#include "image/c_writer.hpp"
#include "text/files.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

namespace fs = std::filesystem;

/// An object's tree in one layout.
struct TreeFiles {
  std::string name;
  SourceFiles text;
  std::uint64_t flash_bytes;
};
using ObjectFiles = std::array<TreeFiles, 2>;  ///< pre-indexed, post-indexed

template <Layout layout>
TreeFiles write_tree(const std::string& object, const bake::BuildTree& tree,
                     const bake::LatticeMesh& mesh) {
  const auto baked = bake::lay_out<std::uint16_t, layout>(tree, mesh);
  const std::string name = object + (layout == Layout::pre_indexed ? "_pre" : "_post");
  const std::vector<std::uint32_t> image = bake::image_of(baked, true);
  return {name, mesh_in_c(image, {name, name}, ""), 4 * image.size()};
}

/// The contents of one firmware image.
struct Image {
  std::string setups;             ///< lines of its table
  std::set<std::string> objects;  ///< the names of the objects
  std::uint64_t bytes = 0;
};

class Distribution {
 public:
  explicit Distribution(const FirmwareOptions& options)
      : max_bytes_(options.max_bytes), images_(options.images) {
    for (std::size_t i = 0; i < scene::kSetups.size(); ++i) {
      const scene::Setup& setup = scene::kSetups[i];
      const std::string head = concat("{", i, ", ", setup.table, ", \"", setup.name, "\"}");
      if (!has_16_bits(setup.a) || !has_16_bits(setup.b) || !place(setup, head)) {
        left_out_ += "    " + head + ",\n";
      }
    }
  }

  FileSet files(const fs::path& folder) const {
    FileSet files;
    std::set<std::string> written;
    for (std::size_t i = 0; i < images_.size(); ++i) {
      files.add(folder / concat("setups_", i + 1, ".cpp"),
                source(images_[i], i == 0 ? left_out_ : std::string()));
      written.insert(images_[i].objects.begin(), images_[i].objects.end());
    }
    for (const std::string& object : written) {
      for (const TreeFiles& tree : objects_.at(object)) {
        files.add(folder / (tree.name + ".fbvh.h"), tree.text.header);
        files.add(folder / (tree.name + ".fbvh.c"), tree.text.source);
      }
    }
    return files;
  }

 private:
  /// A tree has twice as many nodes as triangles, less one.
  static bool has_16_bits(const scene::PaperObject& object) { return object.faces() <= 32768; }

  const ObjectFiles& files_of(const scene::PaperObject& object) {
    const std::string name = name_of(object);
    if (objects_.count(name) == 0) {
      const bake::LatticeMesh mesh = make_mesh(object);
      const bake::BuildTree tree = bake::build_median(mesh, 1);
      objects_[name] = {write_tree<Layout::pre_indexed>(name, tree, mesh),
                        write_tree<Layout::post_indexed>(name, tree, mesh)};
    }
    return objects_[name];
  }

  /// Puts a setup into the first image with capacity; false if there is none.
  bool place(const scene::Setup& setup, const std::string& head) {
    for (Image& image : images_) {
      Image filled = image;
      for (const scene::PaperObject& object : {setup.a, setup.b}) {
        if (filled.objects.insert(name_of(object)).second) {
          for (const TreeFiles& tree : files_of(object)) {
            filled.bytes += tree.flash_bytes;
          }
        }
      }
      if (filled.bytes <= max_bytes_) {
        filled.setups += line(setup, head);
        image = filled;
        return true;
      }
    }
    return false;
  }

  static std::string line(const scene::Setup& setup, const std::string& head) {
    std::string text = "    {" + head + ",\n";
    for (const scene::PaperObject& object : {setup.a, setup.b}) {
      const std::string name = name_of(object);
      text += concat("     {", name, "_pre_image,\n      ", name, "_post_image},\n");
    }
    const Point& t = setup.translation;
    return concat(text, "     {", t.x, ", ", t.y, ", ", t.z, "}},\n");
  }

  std::string source(const Image& image, const std::string& left_out) const {
    std::string text =
        "// Written by `flashbvh bench --firmware`; run it again instead of changing this.\n"
        "#include \"setups.hpp\"\n\n";
    for (const std::string& object : image.objects) {
      for (const TreeFiles& tree : objects_.at(object)) {
        text += "#include \"" + tree.name + ".fbvh.c\"\n";
      }
    }
    return text + "\nnamespace benchmark {\n\nconst Setup kSetups[] = {\n" + image.setups +
           "    {}};\n\nconst Head kLeftOut[] = {\n" + left_out +
           "    {}};\n\n}  // namespace benchmark\n";
  }

  std::uint64_t max_bytes_;
  std::map<std::string, ObjectFiles> objects_;
  std::vector<Image> images_;
  std::string left_out_;
};

}  // namespace

void write_firmware(const FirmwareOptions& options) {
  Distribution(options).files(options.folder).write();
}

}  // namespace flashbvh::tool
