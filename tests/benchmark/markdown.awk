# A Markdown table, aligned so that it reads as it stands: the first column left, the others right.
#     begin_table(); cell("algorithm"); cell("iterations"); end_row(); ...; print_table()
function begin_table() {
  table_rows = 0
  table_columns = 0
  split("", table_width)
}

function cell(content) {
  cells[table_rows, table_columns] = content
  if (length(content) > table_width[table_columns] + 0) {
    table_width[table_columns] = length(content)
  }
  ++table_columns
}

function end_row() {
  row_length = table_columns
  table_columns = 0
  ++table_rows
}

function dashes(count,    line) {
  for (; count > 0; --count) {
    line = line "-"
  }
  return line
}

function print_table(    row, column) {
  for (row = 0; row < table_rows; ++row) {
    printf "|"
    for (column = 0; column < row_length; ++column) {
      printf column ? " %*s |" : " %-*s |", table_width[column], cells[row, column]
    }
    printf "\n"
    if (row == 0) {
      printf "|"
      for (column = 0; column < row_length; ++column) {
        printf " %s |", column ? dashes(table_width[column] - 1) ":" : dashes(table_width[column])
      }
      printf "\n"
    }
  }
  printf "\n"
}
