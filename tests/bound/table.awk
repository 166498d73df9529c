# The table: what the source's lines say of loops, and what calls are counted apart. See
# longest_path.sh.

# The table's lines for a function: fills kinds[], limit[kind] (-1: not a number), and marked[i].
function read_marks(f,    i, row, lines, at, file) {
  split("", marked)
  split("", limit)
  for (row = 1; row <= rows; ++row) {
    if (f !~ row_function[row]) {
      continue
    }
    limit[row_kind[row]] = row_count[row] ~ /^[0-9]+$/ ? row_count[row] + 0 : -1
    for (i = first_of[f]; i <= last_of[f]; ++i) {
      if (row_file[row] == "-") {
        file = mnemonic[i]
        sub(/\.[nw]$/, "", file)
        if (file == row_text[row]) {
          marked[i] = row_kind[row]
        }
        continue
      }
      at = place[i]
      file = at
      sub(/:[0-9]+$/, "", file)
      sub(/^.*:/, "", at)
      if (ends_with(file, row_file[row]) && (row, at) in row_line) {
        marked[i] = row_kind[row]
      }
    }
  }
}

function ends_with(text, tail) {
  return length(text) >= length(tail) && substr(text, length(text) - length(tail) + 1) == tail
}

function is_apart(f,    k) {
  for (k = 1; k <= aparts; ++k) {
    if (f ~ apart[k]) {
      return 1
    }
  }
  return 0
}

# "cut FUNCTION KIND COUNT FILE TEXT..." and "apart FUNCTION": see longest_path.sh.
function read_table(    text, field, n, line, source, found) {
  while ((getline text <table) > 0) {
    if (text ~ /^ *(#|$)/) {
      continue
    }
    n = split(text, field, " ")
    if (field[1] == "apart") {
      apart[++aparts] = field[2]
      continue
    }
    ++rows
    row_function[rows] = field[2]
    row_kind[rows] = field[3]
    row_count[rows] = field[4]
    row_file[rows] = field[5]
    sub(/^ *[^ ]+ +[^ ]+ +[^ ]+ +[^ ]+ +[^ ]+ +/, "", text)
    row_text[rows] = text
    if (row_file[rows] == "-") {
      continue
    }
    line = found = 0
    while ((getline source <(root "/" row_file[rows])) > 0) {
      ++line
      if (index(source, text)) {
        row_line[rows, line] = 1
        found = 1
      }
    }
    close(root "/" row_file[rows])
    if (!found) {
      print "longest_path: no '" text "' in " row_file[rows] | "cat >&2"
      failed = 1
      exit 1
    }
  }
}
