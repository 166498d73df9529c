#include "robot/matrix/zone_side.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "bake/surface.hpp"

namespace flashbvh::tool {
namespace {

/// The file or primitive that each of a link's triangles comes from.
std::vector<std::uint32_t> sources_of(const ModelLink& link) {
  std::vector<std::uint32_t> sources(link.mesh.triangles.size());
  for (std::size_t i = 1; i < link.source_begins.size(); ++i) {
    std::fill(sources.begin() + static_cast<std::ptrdiff_t>(link.source_begins[i]), sources.end(),
              static_cast<std::uint32_t>(i));
  }
  return sources;
}

}  // namespace

ZoneSide::ZoneSide(const ModelLink& link, const Transform& frame)
    : mesh_(link.mesh), to_joint_(inverse(frame)) {
  const std::vector<std::uint32_t> sources = sources_of(link);
  const std::size_t count = mesh_.triangles.size();
  bake::Shells shells(count);
  std::map<std::tuple<std::uint32_t, double, double, double>, std::uint32_t> first;
  for (std::uint32_t i = 0; i < count; ++i) {
    for (const std::uint32_t corner : mesh_.triangles[i]) {
      const auto& [x, y, z] = mesh_.vertices[corner];
      const auto place = first.try_emplace({sources[i], x, y, z}, i).first;
      shells.join(i, place->second);
    }
  }
  std::map<std::uint32_t, std::uint32_t> numbers;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto number = static_cast<std::uint32_t>(numbers.size());
    shells_.push_back(numbers.try_emplace(shells.first_of(i), number).first->second);
  }
  shell_count_ = static_cast<std::uint32_t>(numbers.size());
}

bake::SourceMesh ZoneSide::part(const std::vector<bool>& shells) const {
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t i = 0; i < shells_.size(); ++i) {
    if (shells[shells_[i]]) {
      numbers.push_back(i);
    }
  }
  return part_of(mesh_, numbers);
}

bake::SourceMesh ZoneSide::outside(const std::vector<bool>& shells, const ZoneShape& shape,
                                   double edge) const {
  ZoneCut cut(shape, to_joint_, edge);
  for (std::size_t i = 0; i < shells_.size(); ++i) {
    if (shells[shells_[i]]) {
      cut.add(simplify::triangle_of(mesh_, mesh_.triangles[i]));
    }
  }
  return cut.mesh();
}

std::array<std::vector<bool>, 2> take_touching_shells(const std::array<ZoneSide, 2>& sides,
                                                      std::vector<ZoneLook>& looks) {
  std::array<std::vector<bool>, 2> shells;
  for (std::size_t side = 0; side < 2; ++side) {
    std::vector<std::size_t> counts(sides[side].shell_count());
    for (const ZoneLook& look : looks) {
      std::set<std::uint32_t> touching;
      for (const auto& contact : look.contacts) {
        touching.insert(sides[side].shell_of(contact[side]));
      }
      for (const std::uint32_t shell : touching) {
        ++counts[shell];
      }
    }
    for (const std::size_t count : counts) {
      shells[side].push_back(2 * count >= looks.size());
    }
  }
  for (auto& [number, frame, contacts] : looks) {
    const auto is_other = [&](const auto& contact) {
      return !shells[0][sides[0].shell_of(contact[0])] || !shells[1][sides[1].shell_of(contact[1])];
    };
    contacts.erase(std::remove_if(contacts.begin(), contacts.end(), is_other), contacts.end());
  }
  return shells;
}

}  // namespace flashbvh::tool
