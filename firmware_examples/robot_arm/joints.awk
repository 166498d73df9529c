# Reads the joints between the arm's links from its URDF file and writes them as C++:
#     awk -f joints.awk "KR5 sixx R650.urdf" >joints.hpp
# Status 1, and why on standard error, if the file is not what this expects: six revolute joints that
# make a chain of the seven links, in order, none of them rotated at rest.
BEGIN { links = split("base_link shoulder bicep elbow forearm wrist palm", link, " ") }
{ text = text " " $0 }
END {
  gsub(/[\t\r]/, " ", text)
  count = split(text, piece, "<joint")
  for (i = 2; i <= count; ++i) {
    joint = piece[i]
    sub("</joint>.*", "", joint)
    if (joint ~ /type="revolute"/) add_joint()
  }
  if (joints != links - 1) fail(joints + 0 " revolute joints, not " links - 1)
  print "// Written by joints.awk; the numbers are those of the URDF file.\n#ifndef ROBOT_ARM_JOINTS_HPP"
  print "#define ROBOT_ARM_JOINTS_HPP\n\n#include \"arm.hpp\"\n\nconstexpr Joint kJoints[kJointCount] = {"
  printf "%s};\n\n#endif\n", lines
}

function fail(why) {
  if (!failed) print FILENAME ": not the arm that was expected: " why > "/dev/stderr"
  failed = 1
  exit 1
}

# value(TAG, NAME): what the attribute of the joint's tag says.
function value(tag, name, rest) {
  rest = joint
  if (tag != "" && !sub(".*<" tag " ", " ", rest)) fail("a joint without " tag)
  if (tag != "") sub("/>.*", "", rest)
  if (!match(rest, " " name "=\"[^\"]*\"")) fail("a joint without " tag " " name)
  rest = substr(rest, RSTART, RLENGTH)
  gsub("^[^\"]*\"|\"$", "", rest)
  return rest
}

# literals(TEXT, N): N numbers as floats of C++.
function literals(numbers, n, word, i, list, literal) {
  if (split(numbers, word, " ") != n) fail("not " n " numbers: " numbers)
  for (i = 1; i <= n; ++i) {
    if (word[i] !~ /^-?[0-9]+(\.[0-9]*)?([eE][-+]?[0-9]+)?$/) fail("no number: " word[i])
    literal = sprintf("%.9g", word[i])
    list = list (i > 1 ? ", " : "") literal (literal ~ /[.e]/ ? "f" : ".0f")
  }
  return list
}

function add_joint(origin) {
  ++joints
  if (value("parent", "link") != link[joints] || value("child", "link") != link[joints + 1])
    fail("joint " joints " is not between " link[joints] " and " link[joints + 1])
  if (value("origin", "rpy") !~ /^ *0 +0 +0 *$/) fail("joint " joints " is rotated at rest")
  lines = lines "    {{" literals(value("origin", "xyz"), 3) "}, {" literals(value("axis", "xyz"), 3) "}, " \
    literals(value("limit", "lower"), 1) ", " literals(value("limit", "upper"), 1) "},  // " \
    value("", "name") "\n"
}
