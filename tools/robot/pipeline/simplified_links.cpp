#include "robot/pipeline/simplified_links.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "bake/quantise.hpp"
#include "image/simplify_options.hpp"
#include "text/numbers.hpp"
#include "text/parallel.hpp"

namespace flashbvh::tool {
namespace {

/// Joint zones are chosen before the fitting length, and the parts next to zones, are known.
constexpr double kRoomForParts = 1.5;

double longest_of(const Model& model) {
  double longest = 0;
  for (const ModelLink& link : model.links) {
    longest = std::max(longest, longest_side(bake::extent_of(link.mesh).size()));
  }
  return simplify::kLongestPart * longest;
}

/// The reader's rounding error in metres; it reduces the deviation left for simplifying.
double read_precision(const Model& model) {
  double most = 0;
  for (const ModelLink& link : model.links) {
    most = std::max(most, std::sqrt(3.0) * link.precision);
  }
  return most;
}

/// Larger leaves save bytes, but queries cost more.
std::vector<std::uint32_t> fitting_leaf_sizes(const RobotRequest& request) {
  std::vector<std::uint32_t> sizes = {request.leaf_size};
  for (const std::uint32_t size : {kLargeLeaf, kLargestLeaf}) {
    if (!request.has_leaf_size && size > sizes.back()) {
      sizes.push_back(size);
    }
  }
  return sizes;
}

simplify::BytesOf bytes_of_links(const Model& model, double cell, const std::string& path) {
  return [&model, cell, path](const std::vector<simplify::Coarsening>& meshes,
                              std::uint32_t leaf_size) {
    std::vector<double> bytes(meshes.size());
    for_each_in_parallel(meshes.size(), [&](std::size_t i) {
      BakeOptions options;
      options.cell = cell;
      options.leaf_size = leaf_size;
      bytes[i] =
          coarse_bytes(link_input(model.links[i], path), meshes[i], options, model.links[i].name);
    });
    return std::accumulate(bytes.begin(), bytes.end(), 0.0);
  };
}

}  // namespace

SimplifiedLinks::SimplifiedLinks(const Model& model, double cell, const RobotRequest& request)
    : request_(request), cell_(cell), leaf_size_(request.leaf_size) {
  if (!request.simplify && !request.fit) {
    return;
  }
  if (request.simplify) {
    length_ = simplify_length(request);
    for (const ModelLink& link : model.links) {
      const double least = link_deviation(link, cell);
      if (length_ < least) {
        throw UserError("--simplify " + *request.simplify, "is less than rounding moves link '",
                        link.name, "', ", significant(least, 3),
                        " m; give more, or a finer --cell");
      }
    }
    expected_ = length_;
  } else {
    add(model, {}, {});
    expected_ = kRoomForParts *
                simplify::likely_length(meshes_, bytes_to_fit(*request.fit), longest_of(model));
  }
}

void SimplifiedLinks::add(const Model& model, const Deadline& deadline, const Told& told) {
  const std::size_t first = meshes_.size();
  for (std::size_t i = first; i < model.links.size(); ++i) {
    meshes_.emplace_back(model.links[i].mesh, cell_);
  }
  if (length_ == 0) {
    return;
  }
  const double limit = length_ - read_precision(model);
  for_each_in_parallel(meshes_.size() - first, [&](std::size_t i) {
    told("simplifying " + model.links[first + i].name, 0);
    simplify::Coarsening& mesh = meshes_[first + i];
    // Most links need less than twice an equal share of the time.
    mesh.coarsen(std::max(limit, mesh.rounding()),
                 turn_of(deadline, meshes_.size() - first - i, 2));
  });
}

void SimplifiedLinks::fit(const Model& model, double most, const Deadline& deadline) {
  const double longest = longest_of(model);
  const auto found = simplify::fit(meshes_, most, longest, fitting_leaf_sizes(request_),
                                   bytes_of_links(model, cell_, request_.urdf), deadline);
  if (!found && deadline.is_past()) {
    throw UserError("--fit " + *request_.fit, "is not reached in --time ", *request_.time,
                    "; give more of either, or --simplify");
  }
  if (!found) {
    throw UserError("--fit " + *request_.fit, "is not reached by simplifying to ",
                    significant(longest, 3),
                    " m, a twentieth of the largest link; give more bytes");
  }
  length_ = found->length == 0 ? 0 : found->length + read_precision(model);
  leaf_size_ = found->leaf_size;
}

std::set<std::string> SimplifiedLinks::unfinished(const Model& model) const {
  std::set<std::string> names;
  for (std::size_t i = 0; i < meshes_.size(); ++i) {
    if (meshes_[i].is_unfinished()) {
      names.insert(model.links[i].name);
    }
  }
  return names;
}

std::vector<BakedLink> SimplifiedLinks::baked(const Model& model, std::size_t own_bytes,
                                              const Deadline& deadline, const Told& told) {
  if (request_.simplify || request_.fit) {
    add(model, deadline, told);
  }
  if (request_.fit) {
    const double most = bytes_to_fit(*request_.fit);
    const auto own = static_cast<double>(own_bytes);
    if (own >= most) {
      throw UserError("--fit " + *request_.fit, "is less than the robot takes without any mesh, ",
                      own_bytes, " bytes; give more");
    }
    told("simplifying", 0);
    fit(model, most - own, deadline);
  }
  std::vector<BakedLink> links(model.links.size());
  for_each_in_parallel(links.size(), [&](std::size_t i) {
    const simplify::Coarsening* const coarse = length_ == 0 ? nullptr : &meshes_[i];
    try {
      links[i] = bake_link(model.links[i], cell_, leaf_size_, request_.urdf, coarse);
    } catch (const UserError&) {
      if (coarse != nullptr && coarse->is_unfinished()) {
        throw UserError("--time " + *request_.time, "left too little to simplify ",
                        tool::quoted(model.links[i].name), " to what firmware holds; give more");
      }
      throw;
    }
  });
  return links;
}

}  // namespace flashbvh::tool
