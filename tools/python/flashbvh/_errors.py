"""The exceptions and warnings of the native part."""


class Error(ValueError):
    """What the program `flashbvh` refuses, with its message: what is wrong where, and the remedy."""

    __module__ = "flashbvh"


class BakeWarning(UserWarning):
    """What the program `flashbvh` warns of, with its message."""

    __module__ = "flashbvh"
