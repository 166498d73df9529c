"""Random arms of boxes, as URDF, with all types of joints; and a robot's image to change, with repaired checksums."""
import struct
import zlib

LIMITS = {"revolute": (-2.0, 1.5), "prismatic": (-0.05, 0.1), "mimic": (-3.0, 3.0)}


def any_arm(random, joints):
    """A chain of links of about 0.3 m with joints of these types; a mimic follows the first one. Neighbours are apart
    or overlap."""
    def box():
        x, y, z = random.uniform(0.03, 0.08), random.uniform(0.03, 0.08), random.uniform(0.15, 0.3)
        return (f'<collision><origin xyz="0 0 {z / 2:.4f}"/><geometry><box size="{x:.4f} {y:.4f} {z:.4f}"/></geometry>'
                '</collision>'), z

    shape, height = box()
    text, parent = f'<robot name="arm"><link name="base">{shape}</link>', "base"
    for i, kind in enumerate(joints):
        shape, size = box()
        limit = '<limit lower="%g" upper="%g" effort="1" velocity="1"/>' % LIMITS[kind] if kind in LIMITS else ""
        follows = '<mimic joint="j0" multiplier="0.7" offset="0.1"/>' if kind == "mimic" else ""
        gap = random.choice([0.01, -0.03])
        text += (f'<link name="l{i}">{shape}</link><joint name="j{i}" type="{kind.replace("mimic", joints[0])}">'
                 f'<parent link="{parent}"/><child link="l{i}"/><origin xyz="{random.uniform(0, 0.1) * (gap > 0):.4f} 0 '
                 f'{height + gap:.4f}" rpy="{random.uniform(-1, 1):.3f} 0 0"/><axis '
                 f'xyz="{random.choice(["1 0 0", "0 1 0", "0 0 1", "0.6 0 0.8"])}"/>{limit}{follows}</joint>')
        parent, height = f"l{i}", size
    return text + "</robot>"


def padded(size):
    """Rounded up to whole words."""
    return (size + 3) // 4 * 4


class Rows:
    """Rows of one array: fields by name."""
    def __init__(self, data, begin, count, form, names):
        self.data, self.begin, self.count = data, begin, count
        self.form, self.names = struct.Struct("<" + form), names.split()
        self.end = begin + count * self.form.size

    def __len__(self):
        return self.count

    def __iter__(self):
        return map(self.__getitem__, range(self.count))

    def __getitem__(self, i):
        values = self.form.unpack_from(self.data, self.begin + i * self.form.size)
        return dict(zip(self.names, values))

    def set(self, i, **fields):
        row = {**self[i], **fields}
        self.form.pack_into(self.data, self.begin + i * self.form.size, *(row[name] for name in self.names))


class Image:
    """lib/docs/format.md, "The robot's image"."""
    HEADER = Rows(bytearray(), 0, 1, "IHBBIIIIQIIHHHBBHH",
                  "magic version joints links bytes crc hash slack cell pair_joints tables pairs reaches names variables "
                  "mounts unguarded zeros")

    def __init__(self, data):
        self.data = bytearray(data)
        self.layout()

    def layout(self):
        data, at = self.data, 52
        self.header = Rows(data, 0, 1, self.HEADER.form.format[1:], " ".join(self.HEADER.names))
        h = self.header[0]
        arrays = {"joints": ("9i3iiiiiBBBBI", " ".join([*(f"r{i}" for i in range(9)), "x y z lower upper multiplier offset "
                                                        "shift parent variable type zeros"])),
                  "links": ("3iIHBBI", "x y z radius first joint zero deviation"),
                  "pairs": ("IIIBBBB", "stop warn reach a b joints_a joints_b"), "reaches": ("I", "value"),
                  "mounts": ("52s", "bytes"), "unguarded": ("BBBBI", "a b why joint radius"), "tables": ("B", "byte")}
        for name, (form, names) in arrays.items():
            rows = Rows(data, at, h[name], form, names)
            setattr(self, name, rows)
            at = rows.end
        names = bytes(data[at:at + h["names"]]).split(b"\0")
        self.joint_names = [name.decode() for name in names[1:1 + h["joints"]]]
        self.link_names = [name.decode() for name in names[1 + h["joints"]:1 + h["joints"] + h["links"]]]
        self.mount_names = [name.decode() for name in names[1 + h["joints"] + h["links"]:-1]]
        self.names_at = at
        at = padded(at + h["names"])
        self.meshes = []
        for _ in range(h["links"]):
            self.meshes.append(at)
            at += struct.unpack_from("<I", data, at + 8)[0]

    def branch(self, link):
        joints, j = [], self.links[link]["joint"]
        while j != 255:
            joints.append(j)
            j = self.joints[j]["parent"]
        return joints

    def whole_of(self, link):
        return self.link_names.index(self.link_names[link])

    def name(self, link):
        """The name that the checker prints: a part of a link has its number."""
        return self.link_names[link] + ("" if self.whole_of(link) == link else f"#{link}")

    def between(self, a, b):
        a, b = self.branch(a), self.branch(b)
        return [j for j in a if j not in b], [j for j in b if j not in a]

    def boxes(self, joint):
        """The number of joint boxes of a joint's coordinates in a table."""
        row = self.joints[joint]
        width = (1 << 28) - 1 if row["type"] == 1 else row["upper"] - row["lower"]
        shift = max(0, width.bit_length() - 5)
        return (width >> shift) + 1

    def table_size(self, pair):
        joints = sum(self.between(pair["a"], pair["b"]), [])
        if not 0 < len(joints) <= 2 or any(self.joints[j]["shift"] for j in joints):
            return 0
        return self.boxes(joints[0]) * (self.boxes(joints[1]) if len(joints) == 2 else 1)

    def mesh(self, link):
        """The mesh's arrays of nodes, triangles' corners and vertices: their offsets and their lengths."""
        at = self.meshes[link]
        nodes, leaves, triangles, vertices = struct.unpack_from("<4I", self.data, at + 16)
        corners = at + 80 + 16 * nodes + (2 * padded(2 * nodes) if self.data[at + 79] & 1 else 0)
        offsets = padded(2 * leaves + 2) if leaves != triangles else 0
        place = corners + padded(6 * triangles) + padded(2 * triangles) + offsets
        return (at + 80, nodes), (corners, triangles), (place, vertices)

    def repair_sums(self):
        """Recomputes the reaches of pairs."""
        for i, pair in enumerate(self.pairs):
            a, b = self.between(pair["a"], pair["b"])
            sums = sum(self.reaches[self.links[link]["first"] + n]["value"]
                       for link, joints in ((pair["a"], a), (pair["b"], b)) for n in range(len(joints)))
            self.pairs.set(i, reach=sums % (1 << 32))

    def remove_pair(self, i):
        begin = self.tables.begin + sum(self.table_size(self.pairs[k]) for k in range(i))
        pair, size = self.pairs[i], self.table_size(self.pairs[i]) if len(self.tables) else 0
        names_end = self.names_at + self.header[0]["names"]
        at = self.pairs.begin + 16 * i
        front = self.data[:at] + self.data[at + 16:begin] + self.data[begin + size:names_end]
        self.data[:] = front + bytes(-len(front) % 4) + self.data[padded(names_end):]
        h = self.header[0]
        self.header.set(0, bytes=len(self.data), pairs=h["pairs"] - 1, tables=h["tables"] - size,
                        pair_joints=h["pair_joints"] - pair["joints_a"] - pair["joints_b"])
        self.layout()

    def repaired(self):
        """The bytes, with repaired checksums and hash."""
        data, h, value = self.data, self.header[0], 2166136261

        def add(begin, end, value):
            for byte in data[begin:end]:
                value = (value ^ byte) * 16777619 & 0xFFFFFFFF
            return value

        for link, at in enumerate(self.meshes):
            size = struct.unpack_from("<I", data, at + 8)[0]
            struct.pack_into("<I", data, at + 12, zlib.crc32(data[at:at + 12] + data[at + 16:at + size]))
        value = add(self.joints.begin, self.reaches.end, value)
        value = add(self.tables.begin, self.tables.end, value)
        value = add(20, 32, value)
        for link, at in enumerate(self.meshes):
            for (begin, count), size in zip(self.mesh(link), (16, 6, 6)):
                value = add(begin, begin + size * count, value)
            value = add(at + 44, at + 56, value)
        self.header.set(0, hash=value)
        own = self.meshes[0]
        self.header.set(0, crc=zlib.crc32(data[:12] + data[16:own]))
        return bytes(data)
