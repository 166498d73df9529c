// First stages of a robot's way from its files to an image: it is read, then prepared for
// decisions.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "image/mesh_warnings.hpp"
#include "robot/matrix/baked_part.hpp"
#include "robot/model.hpp"
#include "robot/pipeline/request.hpp"
#include "text/deadline.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// Hears of each step as it begins, with its weight: about the number of decided pairs that take as
/// long.
using Told = std::function<void(const std::string& step, double weight)>;

/// The sum of all steps' weights.
double steps_of(const Model& model);

/// The robot as described. UserError for errors in its files or in `request`.
Model described_robot(const RobotRequest& request, Warnings& warnings);

/// A robot without any decisions.
struct Prepared {
  Model model;
  double cell;                    ///< metres
  std::vector<BakedPart> wholes;  ///< trees of the links, on which pairs are decided
  std::vector<Size> sizes;        ///< of the links, in their own frames, in metres
  AllDistances distances{};       ///< as requested
  ZoneRadii radii{};              ///< as requested
};

/// When so large a part of --time is over; without it, never.
inline Deadline deadline_of(const RobotRequest& request, double part) {
  return request.time ? in_seconds(request.began, part * seconds(*request.time)) : Deadline{};
}

/// Chooses the cell, and bakes links for decisions. Warns of odd sizes and coarse cells. UserError
/// for requests that the robot can't meet.
Prepared prepare(Model model, const RobotRequest& request, const Told& told, Warnings& warnings);

/// Sizes in metres, in the links' own frames.
std::vector<Size> link_sizes(const Model& model);
/// Sizes of a model without meshes, from the baked meshes. `cell`: of the meshes.
std::vector<Size> link_sizes(const Model& model, const Mesh* meshes, double cell);

/// Warns of links with odd sizes, and of a cell coarser than a tenth of the least stop distance or
/// of few cells a link.
void warn_of_sizes(const Prepared& robot, const RobotRequest& request, Warnings& warnings);

}  // namespace flashbvh::tool
