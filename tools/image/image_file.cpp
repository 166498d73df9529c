#include "image/image_file.hpp"

#include <algorithm>
#include <cstring>
#include <filesystem>

#include "flashbvh/image.hpp"
#include "text/files.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

std::string refusal(Status status, std::size_t size, const HeaderFacts& header) {
  switch (status) {
    case Status::image_truncated:
      return concat("is truncated: it has ", size, " bytes",
                    size < header.size ? concat(" and needs a header of ", header.size)
                                       : concat(" of ", header.byte_count),
                    "; copy or bake it again");
    case Status::image_not_flashbvh:
      return header.other;
    case Status::image_version:
      return concat("is written in version ", header.version,
                    " of the image format, this program reads version ", header.newest,
                    "; bake it again");
    case Status::image_corrupt:
      return "is corrupt: a checksum does not match; copy or bake it again";
    case Status::image_kind:
      return "has a layout or index width that this program does not know; bake it again";
    default:
      return "is invalid: its checksum matches, but its contents break a rule of the format; bake "
             "it again";
  }
}

template <class Index, Layout layout>
Status open_as(const void* bytes, std::size_t size, AnyTree& any, LevelArrays& levels) {
  return open_levelled(bytes, size, any.emplace<BasicMeshWithLevels<Index, layout>>(),
                       levels.emplace<std::vector<Index>>());
}

Status open_any(const void* bytes, std::size_t size, const ImageHeader& header, AnyTree& any,
                LevelArrays& levels) {
  constexpr Layout pre = Layout::pre_indexed;
  constexpr Layout post = Layout::post_indexed;
  const bool is_pre = header.layout == static_cast<std::uint8_t>(pre);
  if (header.index_bits == 16) {
    return is_pre ? open_as<std::uint16_t, pre>(bytes, size, any, levels)
                  : open_as<std::uint16_t, post>(bytes, size, any, levels);
  }
  return is_pre ? open_as<std::uint32_t, pre>(bytes, size, any, levels)
                : open_as<std::uint32_t, post>(bytes, size, any, levels);
}

double double_of(const std::uint32_t (&words)[2]) {
  double value = 0;
  static_assert(sizeof value == sizeof words);
  std::memcpy(&value, words, sizeof value);
  return value;
}

}  // namespace

void check_opened(Status status, const std::string& path, std::size_t size,
                  const HeaderFacts& header) {
  if (status != Status::done) {
    throw UserError(path, refusal(status, size, header));
  }
  if (size != header.byte_count) {
    throw UserError(path, "has ", size - header.byte_count,
                    " bytes after its end; copy or bake it again");
  }
}

ImageFile::ImageFile(const std::string& path) : ImageFile(path, read_file(path)) {}

ImageFile::ImageFile(const std::string& path, const std::string& bytes)
    : path_(path), words_((bytes.size() + 3) / 4) {
  std::memcpy(words_.data(), bytes.data(), bytes.size());
  // Only for messages: the library validates.
  std::memcpy(&header_, bytes.data(), std::min(bytes.size(), sizeof header_));
  ImageHeader header{};
  Status status = read_image_header(words_.data(), bytes.size(), header);
  if (status == Status::done) {
    status = open_any(words_.data(), bytes.size(), header, tree_, levels_);
  }
  if (status == Status::image_truncated && header_.magic != kImageMagic) {
    status = Status::image_not_flashbvh;
  }
  check_opened(status, path, bytes.size(),
               {sizeof header_, header_.byte_count, header_.version, kImageVersion,
                "is no flashbvh image; name a .fbvh file, which `flashbvh bake` writes"});
}

std::string ImageFile::name() const {
  return std::filesystem::path(path_).stem().string();
}
std::string ImageFile::source() const {
  return {bytes() + image_offsets(header_).name, header_.name_size};
}
double ImageFile::cell() const {
  return double_of(header_.cell);
}
double ImageFile::deviation() const {
  float deviation = 0;
  std::memcpy(&deviation, &header_.deviation, sizeof deviation);
  return static_cast<double>(deviation);
}

std::vector<SourceTriangle> source_triangles(const ImageFile& image) {
  std::vector<SourceTriangle> triangles = std::visit(
      [](const auto& tree) {
        std::vector<SourceTriangle> all(tree.triangle_count);
        for (std::uint32_t i = 0; i < tree.triangle_count; ++i) {
          all[i].number = tree.triangle_ids[i];
          for (std::size_t corner = 0; corner < 3; ++corner) {
            all[i].vertices[corner] = tree.triangles[i].corner[corner];
          }
        }
        return all;
      },
      image.tree());
  std::sort(triangles.begin(), triangles.end(),
            [](const SourceTriangle& t, const SourceTriangle& u) { return t.number < u.number; });
  for (std::size_t i = 1; i < triangles.size(); ++i) {
    if (triangles[i].number == triangles[i - 1].number) {
      throw UserError(image.path(), "is invalid: triangle id ", triangles[i].number,
                      " occurs twice; bake it again");
    }
  }
  return triangles;
}

bake::LatticeMesh mesh_of(const ImageFile& image, const std::vector<SourceTriangle>& triangles) {
  bake::LatticeMesh mesh;
  std::visit(
      [&](const auto& tree) {
        mesh.vertices.assign(tree.vertices, tree.vertices + tree.vertex_count);
      },
      image.tree());
  for (const SourceTriangle& triangle : triangles) {
    mesh.triangles.push_back(triangle.vertices);
  }
  return mesh;
}

const char* layout_name(Layout layout) {
  return layout == Layout::pre_indexed ? "pre" : "post";
}

}  // namespace flashbvh::tool
