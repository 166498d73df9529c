"""cases.py NAME: a test of the host program, a function of one of these modules."""
import bakes
import command_line
import evaluation
import names
import queries
import refusals

command_line.main(bakes, queries, evaluation, refusals, names)
