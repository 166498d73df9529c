# Sourced: quietly COMMAND... writes the command's output to $quiet_log and shows the log's end if the command fails.

quietly() {
  "$@" >"$quiet_log" 2>&1 ||
    { tail -n 40 "$quiet_log" >&2; echo "$(basename "$0" .sh): this failed: $*" >&2; exit 1; }
}
