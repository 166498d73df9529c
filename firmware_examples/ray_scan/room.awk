# awk -f room.awk: a room of 5 x 4 x 2.5 m in OBJ, in millimetres, with a pillar, a table and shelves.
#
# The walls are a box inside out: their triangles face inwards, those of what stands in the room
# outwards, so all that a sensor in the room may see is a front. Winding numbers add up likewise: the
# room's is -1, and in the pillar 0 again. What inside() tells is the air. So no two parts overlap.
function corner(x, y, z) {
  print "v", x, y, z
  return ++corners
}

function face(a, b, c) {
  print "f", a, b, c
}

function quad(a, b, c, d) {
  face(a, b, c)
  face(a, c, d)
}

# side: 1 outwards, -1 inwards.
function box(x0, y0, z0, x1, y1, z1, side,    a, b, c, d, e, f, g, h) {
  a = corner(x0, y0, z0); b = corner(x1, y0, z0); c = corner(x1, y1, z0); d = corner(x0, y1, z0)
  e = corner(x0, y0, z1); f = corner(x1, y0, z1); g = corner(x1, y1, z1); h = corner(x0, y1, z1)
  if (side < 0) {
    quad(a, b, c, d); quad(e, h, g, f); quad(a, e, f, b)
    quad(c, g, h, d); quad(d, h, e, a); quad(b, f, g, c)
  } else {
    quad(a, d, c, b); quad(e, f, g, h); quad(a, b, f, e)
    quad(c, d, h, g); quad(d, a, e, h); quad(b, c, g, f)
  }
}

function pillar(x, y, radius, height, corners_around,    i, turn, low, high) {
  for (i = 0; i < corners_around; ++i) {
    turn = 6.283185307179586 * i / corners_around
    low[i] = corner(int(x + radius * cos(turn) + 0.5), int(y + radius * sin(turn) + 0.5), 0)
    high[i] = corner(int(x + radius * cos(turn) + 0.5), int(y + radius * sin(turn) + 0.5), height)
  }
  low[i] = low[0]
  high[i] = high[0]
  for (i = 0; i < corners_around; ++i) {
    quad(low[i], low[i + 1], high[i + 1], high[i])
  }
  for (i = 1; i < corners_around - 1; ++i) {
    face(low[0], low[i + 1], low[i])
    face(high[0], high[i], high[i + 1])
  }
}

BEGIN {
  box(0, 0, 0, 5000, 4000, 2500, -1)
  pillar(3000, 1500, 200, 2500, 16)
  # The table: a top on four legs.
  box(3500, 2500, 700, 4700, 3300, 740, 1)
  for (x = 3540; x <= 4600; x += 1060) {
    for (y = 2540; y <= 3200; y += 660) {
      box(x, y, 0, x + 60, y + 60, 700, 1)
    }
  }
  # Shelves between two boards, at the wall x = 0.
  box(0, 1000, 0, 350, 1020, 2000, 1)
  box(0, 2180, 0, 350, 2200, 2000, 1)
  for (z = 100; z < 2000; z += 450) {
    box(0, 1020, z, 350, 2180, z + 20, 1)
  }
}
