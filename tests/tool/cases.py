"""cases.py NAME: a test of the host program, a function of bakes.py or queries.py."""
import bakes
import command_line
import queries

command_line.main(bakes, queries)
