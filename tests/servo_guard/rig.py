"""The servo guard's firmware in QEMU, between a simulated servo bus and a host."""
import math
import random
import re
import select
import socket
import subprocess
import time

PING, READ, WRITE, SYNC_READ, SYNC_WRITE, ALL = 1, 2, 3, 0x82, 0x83, 254
TURN = 4096


def packet(number, instruction, *parameters):
    body = [number, len(parameters) + 2, instruction, *parameters]
    return bytes([255, 255, *body, ~sum(body) & 255])


def goals(of, first=42):
    """A SYNC WRITE of goals: {id: count}; from register 41 on with acceleration, time and speed."""
    after, size = ([], 2) if first == 42 else ([0, 0, 232, 3], 7)
    data = [[number, *([50] if first == 41 else []), goal & 255, goal >> 8, *after] for number, goal in of.items()]
    return packet(ALL, SYNC_WRITE, first, size, *sum(data, []))


class Stream:
    """Finds packets in what is received, and counts the bytes between them."""

    def __init__(self):
        self.rest, self.junk = bytearray(), 0

    def packets(self, received):
        self.rest += received
        found = []
        while len(self.rest) >= 4:
            got = bytes(self.rest[:self.rest[3] + 4])
            if got[:2] == b"\xff\xff" and len(got) < got[3] + 4:
                break
            is_packet = len(got) > 5 and got == packet(got[2], got[4], *got[5:-1])
            found += [got] if is_packet else []
            self.junk += not is_packet
            del self.rest[:len(got) if is_packet else 1]
        return found


class Servo:
    """Goes to its goal, ever slower near it, and at most at a speed. Each is late by its own time."""

    def __init__(self, *line):
        self.number, self.offset, self.sign, self.speed = map(int, line)
        self.memory = bytearray(128)
        self.late = [0.02, 0.2, 0.06][self.number % 3]  # seconds
        self.at = float(self.offset)
        self.memory[40] = 1
        self.memory[42:44] = self.offset.to_bytes(2, "little")
        self.is_plugged = True

    @property
    def goal(self):
        return int.from_bytes(self.memory[42:44], "little")

    def step(self, seconds):
        if self.memory[40]:
            way = (self.goal - self.at) * (1 - math.exp(-seconds / self.late))
            most = 1.5 * self.speed * seconds
            self.at += max(-most, min(most, way))
        self.memory[56:58] = round(self.at).to_bytes(2, "little")

    def coordinate(self):
        return round(self.sign * (self.at - self.offset) * (1 << 28) / TURN)


class Rig:
    def __init__(self, machine, firmware, arm, folder):
        """`arm`: the servos' file. `folder`: for sockets and logs."""
        with open(arm) as file:
            lines = re.findall(r"variable_\w+\), (\d+), (\d+), (-?1), (\d+)", file.read())
        self.servos = {int(line[0]): Servo(*line) for line in lines}
        self.log = f"{folder}/text"
        self.positions = open(f"{folder}/positions", "w")
        ends = [f"{folder}/{name}" for name in ("host", "bus")]
        options = sum([["-serial", f"unix:{end},server=on,wait=off"] for end in ends], [])
        self.qemu = subprocess.Popen(
            ["qemu-system-arm", "-M", machine, "-display", "none", "-monitor", "none", "-kernel", firmware, *options,
             "-serial", f"file:{self.log}"], stderr=subprocess.DEVNULL)
        self.host, self.bus = map(self.connected, ends)
        self.to_guard, self.to_host, self.to_bus = bytearray(), Stream(), Stream()
        self.host.setblocking(False)
        self.heard = []   # packets that the bus got
        self.answers = []  # packets that the host got
        self.is_judged = True
        self.last = self.then = time.monotonic()

    def connected(self, path):
        end = socket.socket(socket.AF_UNIX)
        for _ in range(200):
            try:
                end.connect(path)
                return end
            except OSError:
                time.sleep(0.05)
        raise RuntimeError("QEMU does not open its UARTs")

    def close(self):
        self.qemu.terminate()
        self.qemu.wait()
        for end in self.host, self.bus, self.positions:
            end.close()

    def start(self):
        """What comes now is judged from here."""
        self.positions.write("start\n")
        self.is_judged = True

    def step(self):
        now = time.monotonic()
        while now > self.then:
            seconds = min(0.001, now - self.then)
            self.then += seconds
            for servo in self.servos.values():
                servo.step(seconds)
            if self.is_judged and self.then - self.last > 0.002:
                self.last = self.then
                print(*(servo.coordinate() for servo in self.servos.values()), file=self.positions)

    def answer(self, got):
        self.heard.append(got)
        number, instruction, parameters = got[2], got[4], got[5:-1]
        if instruction == SYNC_WRITE:
            first, size = parameters[:2]
            for i in range(2, len(parameters), size + 1):
                if servo := self.plugged(parameters[i]):
                    servo.memory[first:first + size] = parameters[i + 1:i + 1 + size]
        numbers = parameters[2:] if instruction == SYNC_READ else [number]
        for servo in filter(None, map(self.plugged, numbers)):
            data = b""
            if instruction in (READ, SYNC_READ):
                data = servo.memory[parameters[0]:parameters[0] + parameters[1]]
            elif instruction == WRITE:
                servo.memory[parameters[0]:parameters[0] + len(parameters) - 1] = parameters[1:]
            self.bus.sendall(packet(servo.number, 0, *data))

    def plugged(self, number):
        servo = self.servos.get(number)
        return servo if servo and servo.is_plugged else None

    def run(self, seconds, until=lambda: False):
        """Lets time pass. True if `until` came."""
        end = time.monotonic() + seconds
        while not until():
            if time.monotonic() > end:
                return False
            ready, can_send, _ = select.select([self.host, self.bus], [self.host] if self.to_guard else [], [], 0.001)
            self.step()
            if can_send:
                del self.to_guard[:self.host.send(self.to_guard)]
            if self.bus in ready:
                for got in self.to_bus.packets(self.bus.recv(4096)):
                    self.answer(got)
            if self.host in ready:
                self.answers += self.to_host.packets(self.host.recv(4096))
        return True

    def send(self, of):
        self.to_guard += of

    def ask(self, of, seconds=10):
        """The answer to a packet; None if there is none."""
        del self.answers[:]
        self.send(of)
        return self.answers[0] if self.run(seconds, lambda: self.answers) else None

    def text(self):
        with open(self.log) as file:
            return file.read().splitlines()

    def says(self, words, seconds=30):
        """Whether the guard's last line has these words, before long."""
        return self.run(seconds, lambda: any(words in line for line in self.text()[-1:]))

    def at(self):
        return {servo.number: round(servo.at) for servo in self.servos.values()}


def hostile(rig, count, seed, pause=0.005):
    """Sends goals as no host should: everywhere, in bursts, in pieces, broken, with junk and silence between them."""
    draw = random.Random(seed)
    aim = rig.at()
    target = dict(aim)
    for i in range(count):
        if i % 100 == 0:
            ends = draw.choice([[0, TURN - 1], range(TURN), [900, 3200]])
            target = {number: draw.choice([*ends, aim[number]]) for number in aim}
        speed = draw.choice([10, 100, TURN])
        aim = {number: aim[number] + max(-speed, min(speed, target[number] - aim[number])) for number in aim}
        some = {number: aim[number] for number in aim if draw.random() < 0.8} or aim
        sent = goals(some, draw.choice([41, 42]))
        if draw.random() < 0.2:
            number = draw.choice(list(aim))
            sent = packet(number, WRITE, 42, aim[number] & 255, aim[number] >> 8)
        kind = draw.random()
        if kind < 0.03:  # broken
            broken = bytearray(sent)
            broken[draw.randrange(len(broken))] ^= 1 << draw.randrange(8)
            rig.send(bytes(broken))
        elif kind < 0.06:  # junk
            rig.send(bytes(draw.choice([255, draw.randrange(256)]) for _ in range(draw.randrange(60))))
        elif kind < 0.09:  # in two pieces
            cut = draw.randrange(len(sent))
            rig.send(sent[:cut])
            rig.run(draw.choice([0, 0.01]))
            rig.send(sent[cut:])
        elif kind < 0.11:
            rig.send(packet(draw.choice(list(aim)), WRITE, draw.choice([5, 31, 33, 40, 46]), draw.choice([1, 128])))
        rig.send(sent)
        if draw.random() < 0.6:
            rig.run(pause * draw.choice([1, 1, 2, 8]) * (draw.random() < 0.95 or 20))
        rig.run(60, lambda: len(rig.to_guard) < 1000)
