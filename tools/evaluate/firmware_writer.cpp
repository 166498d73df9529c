#include "evaluate/firmware_writer.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <vector>

#include "evaluate/objects.hpp"
#include "evaluate/setups.hpp"
#include "image/cpp_writer.hpp"
#include "text/files.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

namespace fs = std::filesystem;

using SetupIndex = std::size_t;  ///< in scene::kSetups

/// What one firmware image holds.
struct Image {
  std::vector<SetupIndex> setups;
  std::vector<scene::PaperObject> objects;
  std::uint64_t bytes = 0;

  bool has(const scene::PaperObject& object) const {
    return std::find(objects.begin(), objects.end(), object) != objects.end();
  }
};

std::string name_of(const scene::PaperObject& object, Layout layout) {
  constexpr const char* kOrientations[] = {"upright", "lying", "upside_down"};
  return concat(kOrientations[static_cast<std::size_t>(object.orientation)], "_", object.faces(),
                "_radius_", object.radius, (layout == Layout::pre_indexed ? "_pre" : "_post"));
}

template <Layout layout>
std::uint64_t levelled_bytes(const bake::BakedTree<std::uint16_t, layout>& baked) {
  constexpr std::uint64_t kPointers = 8;
  return flash_bytes(baked) + kPointers + 2 * (baked.levels.size() + baked.climb.size());
}

class Distribution {
 public:
  explicit Distribution(const FirmwareOptions& options)
      : options_(options), images_(options.images) {
    for (SetupIndex i = 0; i < scene::kSetups.size(); ++i) {
      if (!place(i)) {
        left_out_.push_back(i);
      }
    }
  }

  const std::vector<Image>& images() const { return images_; }
  const std::vector<SetupIndex>& left_out() const { return left_out_; }
  const BothLayouts<std::uint16_t>& baked(const scene::PaperObject& object) {
    return objects_.get(object).baked<std::uint16_t>();
  }

 private:
  /// Into the first image with room; false if there is none.
  bool place(SetupIndex i) {
    const scene::Setup& setup = scene::kSetups[i];
    if (std::max(setup.a.faces(), setup.b.faces()) >
        std::min(options_.max_faces, kMostFirmwareFaces)) {
      return false;
    }
    for (Image& image : images_) {
      std::vector<scene::PaperObject> added;
      std::uint64_t bytes = image.bytes;
      for (const scene::PaperObject& object : {setup.a, setup.b}) {
        if (!image.has(object) && std::find(added.begin(), added.end(), object) == added.end()) {
          added.push_back(object);
          bytes += levelled_bytes(baked(object).pre) + levelled_bytes(baked(object).post);
        }
      }
      if (bytes <= options_.max_bytes) {
        image.setups.push_back(i);
        image.objects.insert(image.objects.end(), added.begin(), added.end());
        image.bytes = bytes;
        return true;
      }
    }
    return false;
  }

  const FirmwareOptions& options_;
  Objects objects_;
  std::vector<Image> images_;
  std::vector<SetupIndex> left_out_;
};

template <Layout layout>
void add_tree(FileSet& files, const fs::path& folder, const scene::PaperObject& object,
              const bake::BakedTree<std::uint16_t, layout>& baked) {
  const std::string name = name_of(object, layout);
  const SourceFiles text = cpp_of(baked, {name, name, name}, "");
  files.add(folder / (name + ".fbvh.hpp"), text.header);
  files.add(folder / (name + ".fbvh.cpp"), text.source);
}

std::string tree(const scene::PaperObject& object, Layout layout) {
  return "&" + name_of(object, layout) + "::levelled_mesh";
}

std::string head(SetupIndex i) {
  const scene::Setup& setup = scene::kSetups[i];
  return concat("{", i, ", ", setup.table, ", \"", scene::table_title(setup.table), "\", \"",
                setup.name, "\"}");
}

std::string line(SetupIndex i) {
  const scene::Setup& setup = scene::kSetups[i];
  const Point& t = setup.translation;
  std::string text = "    {" + head(i) + ",\n";
  for (const scene::PaperObject& object : {setup.a, setup.b}) {
    text += concat("     {", object.faces(), ", ", tree(object, Layout::pre_indexed), ",\n      ",
                   tree(object, Layout::post_indexed), "},\n");
  }
  return concat(text, "     {", t.x, ", ", t.y, ", ", t.z, "}},\n");
}

std::string source(const Image& image, const std::vector<SetupIndex>& left_out) {
  std::string text =
      "// Written by `flashbvh bench --firmware`; run it again instead of changing this.\n"
      "#include \"setups.hpp\"\n\n";
  for (const scene::PaperObject& object : image.objects) {
    for (const Layout layout : {Layout::pre_indexed, Layout::post_indexed}) {
      text += "#include \"" + name_of(object, layout) + ".fbvh.cpp\"\n";
    }
  }
  text += "\nnamespace benchmark {\n\nconst Setup kSetups[] = {\n";
  for (const SetupIndex i : image.setups) {
    text += line(i);
  }
  text += "    {}};\n\nconst Head kLeftOut[] = {\n";
  for (const SetupIndex i : left_out) {
    text += "    " + head(i) + ",\n";
  }
  return text + "    {}};\n\n}  // namespace benchmark\n";
}

}  // namespace

void write_firmware(const FirmwareOptions& options) {
  const fs::path folder = options.folder;
  Distribution distribution(options);
  FileSet files;
  std::vector<scene::PaperObject> written;
  for (std::size_t i = 0; i < distribution.images().size(); ++i) {
    const Image& image = distribution.images()[i];
    files.add(folder / (concat("setups_", i + 1, ".cpp")),
              source(image, i == 0 ? distribution.left_out() : std::vector<SetupIndex>()));
    for (const scene::PaperObject& object : image.objects) {
      if (std::find(written.begin(), written.end(), object) == written.end()) {
        written.push_back(object);
        add_tree(files, folder, object, distribution.baked(object).pre);
        add_tree(files, folder, object, distribution.baked(object).post);
      }
    }
  }
  files.write();
}

}  // namespace flashbvh::tool
