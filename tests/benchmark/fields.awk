# For other scripts, before their own text: text("setup") and number("visits") are the values of
# setup="..." and visits=... in the current line.
function text(name,    start, rest) {
  start = index($0, " " name "=")
  if (start == 0) {
    return ""
  }
  rest = substr($0, start + length(name) + 2)
  if (substr(rest, 1, 1) == "\"") {
    rest = substr(rest, 2)
    return substr(rest, 1, index(rest, "\"") - 1)
  }
  sub(/ .*/, "", rest)
  return rest
}

function number(name) {
  return text(name) + 0
}
