"""A robot of the tests: an arm of boxes on a column, whose forearm folds back; its fingers mimic each other."""


def link(name, size, at="0 0 0"):
    return (f'<link name="{name}"><collision><origin xyz="{at}"/><geometry><box size="{size}"/></geometry>'
            "</collision></link>")


def joint(name, kind, parent, child, at, axis="0 1 0", limits=None, more=""):
    limit = f'<limit lower="{limits[0]}" upper="{limits[1]}" effort="1" velocity="1"/>' if limits else ""
    return (f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>'
            f'<origin xyz="{at}"/><axis xyz="{axis}"/>{limit}{more}</joint>')


URDF = "".join((
    '<robot name="arm">',
    link("column", "0.2 0.2 0.1"), link("upper", "0.4 0.05 0.05", "0.25 0 0"),
    link("fore", "0.3 0.04 0.04", "0.2 0 0"), link("left", "0.02 0.02 0.1"), link("right", "0.02 0.02 0.1"),
    joint("turn", "continuous", "column", "upper", "0 0 0.2", "0 0 1"),
    joint("fold", "revolute", "upper", "fore", "0.5 0 0", limits=(-3, 3)),
    joint("grip", "prismatic", "fore", "left", "0.4 0.1 0", limits=(-0.09, 0.1)),
    joint("other", "prismatic", "fore", "right", "0.4 -0.1 0", limits=(-0.1, 0.09),
          more='<mimic joint="grip" multiplier="-1"/>'),
    "</robot>\n"))
