// Derived data of a robot's arrays: branches, joints between links, names.
#include "image.hpp"

namespace robot_check {

std::vector<std::uint32_t> Robot::branch(std::uint32_t link) const {
  std::vector<std::uint32_t> joints_in;
  for (std::uint32_t j = links[link].joint; j != kBase; j = joints[j].parent) {
    joints_in.push_back(j);
  }
  return joints_in;
}

Robot::Between Robot::between(std::uint32_t a, std::uint32_t b) const {
  Between of{branch(a), branch(b)};
  while (!of.a.empty() && !of.b.empty() && of.a.back() == of.b.back()) {
    of.a.pop_back();
    of.b.pop_back();
  }
  return of;
}

const Joint& Robot::master(std::uint32_t variable) const {
  std::size_t i = 0;
  while (joints[i].variable != variable || joints[i].shift != 0) {
    ++i;
  }
  return joints[i];
}

std::string Robot::joint_name(std::uint32_t joint) const {
  return joint == kBase ? "base" : joints[joint].name;
}

std::string Robot::link_name(std::uint32_t link) const {
  return links[link].name + (whole_of(link) == link ? "" : "#" + std::to_string(link));
}

std::string Robot::pair_name(std::uint32_t a, std::uint32_t b) const {
  return link_name(a) + " - " + link_name(b);
}

std::uint32_t Robot::whole_of(std::uint32_t link) const {
  for (std::uint32_t i = 0; i < link; ++i) {
    if (links[i].name == links[link].name && links[i].joint == links[link].joint) {
      return i;
    }
  }
  return link;
}

}  // namespace robot_check
