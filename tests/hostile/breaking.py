"""Breaks inputs by their structure: types stay, sizes change, names form cycles, one item becomes a million.

Every function takes a random.Random and returns something new. Nothing returned is larger than about 30 MB.
"""
import copy
import json
import struct
import zlib

MOST_BYTES = 30_000_000
COUNTS = [0, 1, 2, 3, 5, 17, 65, 257, 1_001, 10_001, 100_001, 1_000_000]
NUMBERS = [0, -0.0, 1, -1, 0.5, 255, 256, 16_384, 1e-320, -1e-9, 1e-7, 1e9, 1e12, 1.0000001e12, 1e18, 1e300, -1e308, 2**31,
           2**53 + 1, 2**63, -2**63, 10**40]
TEXTS = ["", " ", "-", "--", ".", "..", "/", "/dev/stdin", "/dev/zero", "/proc/self/environ", "opening", "{}", "null",
         "nan", "inf", "=1/0", "={}", "={x,x,x}", "\x00", "\x1b[2J", "\u202e", "\ud800", "é" * 3, "%s%n", "{x}", "{",
         "={while true do end}", "=(function() return 1 end)()", "a" * 1_025, "state.json", "input.json", "mesh.obj",
         "../input.json", "https://example.org/#", "#"]
LITERALS = ["NaN", "Infinity", "-Infinity", "1e999", "-1e999", "01", "1.", ".5", "0x10", "True", "'a'", "/*a*/1", "",
            "1,", "\"\\u0000\"", "\"\\ud800\""]
EXPRESSIONS = ["(function() while true do end end)()", "string.rep('a', 1e9)", "('a'):rep(1e9)", "1" + "+1" * 20_000,
               "(" * 5_000 + "1" + ")" * 5_000, "{" * 300 + "}" * 300, "S[99][99]", "nil", "0/0", "1/0", "2^1e308",
               "camera", "S", "fighting(", "require('os').exit(1)", "load('return 1')()", "#S", "-S", "S .. 'a'",
               "[[" + "x" * 100_000 + "]]", "depth_step(-1)", "depth_step(1e400)", "answer", "_G", "transpose(1)",
               "fighting().wrong_fraction" + " + fighting().wrong_fraction" * 200, "\"\\xff\"", "\x00", "--[[", "a\nb"]


def repeated(item, count):
    """A list of `count` items, or of as many as fit MOST_BYTES as text."""
    try:
        size = len(json.dumps(item)) + 2
    except (ValueError, TypeError):
        size = 20
    return [item] * max(0, min(count, MOST_BYTES // max(size, 1)))


def places(document, path=()):
    """Returns the paths of all values."""
    found = [path]
    children = document.items() if isinstance(document, dict) else enumerate(document) if isinstance(document, list) else ()
    for key, value in children:
        found += places(value, (*path, key))
    return found


def at(document, path):
    for key in path:
        document = document[key]
    return document


def put(document, path, value):
    if not path:
        return value
    at(document, path[:-1])[path[-1]] = value
    return document


def other_of_its_type(random, value, names):
    """The right type with the wrong size; occasionally another type."""
    if random.random() < 0.15:
        return random.choice([None, True, 0, "", [], {}, [[]], [[[[]]]], "1", 1.5, {"a": {}}])
    if isinstance(value, bool):
        return not value
    if isinstance(value, (int, float)):
        return random.choice([*NUMBERS, value * 1e6, -value, value + 1, int(value) + 0.5])
    if isinstance(value, str):
        return random.choice([*TEXTS, *names, value * random.choice([2, 100, 100_000]), value[:-1], value.upper()])
    if isinstance(value, list):
        kind = random.randrange(5)
        item = random.choice(value) if value else 0
        if kind == 0:
            return repeated(item, random.choice(COUNTS))
        if kind == 1:
            return value[:-1]
        if kind == 2:
            return [*value, item]
        if kind == 3:
            return [value] * 3
        return list(reversed(value))
    if value is None:
        return random.choice([0, "", [], {}])
    kind = random.randrange(4)
    new = dict(value)
    if kind == 0 and new:
        del new[random.choice(list(new))]
    elif kind == 1:
        new[random.choice(["nmae", "state", "lesson", "each", "scene", "$schema", "", "a" * 2_000])] = random.choice(
            [1, "x", {}, []])
    elif kind == 2:
        for i in range(random.choice([10, 1_001, 100_000])):
            new[f"k{i}"] = 0
    else:
        new = {"a": new}
    return new


def broken_document(random, document, names):
    """Returns the bytes of a JSON document broken in one to three places. `names`: files, including this one."""
    paths = places(document)
    document = copy.deepcopy(document)
    for _ in range(random.choice([1, 1, 1, 2, 3])):
        path = random.choice(paths)
        try:
            document = put(document, path, other_of_its_type(random, at(document, path), names))
        except (KeyError, IndexError, TypeError):
            continue  # removed by an earlier break
    text = json.dumps(document, ensure_ascii=random.random() < 0.5)
    kind = random.random()
    if kind < 0.06:
        depth = random.choice([10, 100, 1_000, 100_000])
        opening, closing = random.choice([("[", "]"), ('{"a":', "}")])
        text = text.replace("0", opening * depth + "0" + closing * depth, 1)
    elif kind < 0.12:
        text = text.replace("1", random.choice(LITERALS), 1)
    elif kind < 0.15 and text.startswith("{"):
        text = "{" + text[1:-1] + ", " + text[1:]
    return broken_bytes(random, text.encode("utf-8", "surrogatepass"), 0.12)


def broken_bytes(random, data, share):
    """With this probability truncates, changes, pads, repeats or re-encodes the data."""
    if random.random() >= share or not data:
        return data
    kind = random.randrange(8)
    at_byte = random.randrange(len(data))
    if kind == 0:
        return data[:at_byte]
    if kind == 1:
        return data[:at_byte] + bytes([random.randrange(256)]) + data[at_byte + 1:]
    if kind == 2:
        return data[:at_byte] + bytes(random.choice([1, 1_000, 1_000_000])) + data[at_byte:]
    if kind == 3:
        return data * min(random.choice([2, 1_000]), MOST_BYTES // len(data) + 1)
    if kind == 4:
        return b"\xef\xbb\xbf" + data
    if kind == 5:
        return data.decode("utf-8", "replace").encode("utf-16")
    if kind == 6:
        return b""
    return data + data[:at_byte]


def broken_obj(random, text):
    """Breaks a Wavefront file: counts, indices and numbers that do not fit."""
    lines = text.splitlines()
    kind = random.randrange(12)
    line = random.randrange(len(lines))
    count = random.choice(COUNTS)
    if kind == 0:
        lines[line:line + 1] = repeated(lines[line], count)
    elif kind == 1:
        lines.append("f " + " ".join(random.choice(["1", "-1", "2//1", "3/1"]) for _ in range(min(count, 300_000))))
    elif kind == 2:
        lines.append("f " + " ".join(str(random.choice(NUMBERS + [4, 5, 99])) for _ in range(3)))
    elif kind == 3:
        lines.append("v " + " ".join(str(random.choice([*NUMBERS, "nan", "inf", "1e999", "1,5", ""])) for _ in range(3)))
    elif kind == 4:
        lines[line] = lines[line][:random.randrange(len(lines[line]) + 1)]
    elif kind == 5:
        lines.append("f 1 2 3 " + "\\\n" * min(count, 300_000))
    elif kind == 6:
        lines.append("mtllib " + random.choice(["input.obj", "/dev/zero", "../" * 1_000, "a" * 100_000]))
    elif kind == 7:
        lines += [f"v {i} {i * i % 7} {i * 31% 11}" for i in range(min(count, 300_000))]
        lines.append("f " + " ".join(str(5 + i) for i in range(min(count, 300_000))))
    elif kind == 8:
        lines += [f"s {i}" if i % 2 else "f 1 2 3" for i in range(min(count, 300_000))]
    elif kind == 9:
        lines.append(random.choice(["vp 1", "curv 0 1 1 2", "call input.obj", "l 1 2", "p 1", "f", "v", "vn 0 0 0"]))
    elif kind == 10:
        lines = [random.choice(["l 1 2", "p 1", "# ", "v 1 2 3", ""])] * min(count, 300_000)
    else:
        random.shuffle(lines)
    ending = random.choice(["\n", "\n", "\r\n", "\r"])
    return broken_bytes(random, ending.join(lines).encode() + ending.encode(), 0.15)


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def broken_png(random, data, note):
    """Breaks a PNG: sizes, chunks, pixels or state that do not fit. `note`: the key of its state."""
    chunks, place = [], 8
    while place < len(data):
        length, kind = struct.unpack(">I4s", data[place:place + 8])
        chunks.append([kind, data[place + 8:place + 8 + length]])
        place += length + 12
    choice = random.randrange(9)
    if choice == 0:
        sizes = [0, 1, 63, 65, 16_384, 16_385, 100_000, 2**31 - 1, 2**31, 2**32 - 1]
        chunks[0][1] = struct.pack(">II", random.choice(sizes), random.choice(sizes)) + chunks[0][1][8:]
    elif choice == 1:
        header = bytearray(chunks[0][1])
        header[random.randrange(8, 13)] = random.choice([0, 1, 2, 3, 4, 6, 7, 16, 255])
        chunks[0][1] = bytes(header)
    elif choice == 2:
        bomb = zlib.compress(random.choice([b" ", b"[", b'{"a":']) * random.choice([1_000, 20_000_000]))
        text = note + b"\0\1\0\0\0" + bomb
        chunks[1:1] = [[b"iTXt", text]] * random.choice([1, 2, 50])
    elif choice == 3:
        chunks[1:1] = repeated_chunks([b"tEXt", b"a\0" + b"b" * 100], random.choice(COUNTS))
    elif choice == 4:
        chunks = [each for each in chunks if each[0] != random.choice([b"IDAT", b"IEND", b"IHDR"])]
    elif choice == 5:
        chunks = [[kind, zlib.compress(bytes(random.choice([0, 10, 20_000_000]))) if kind == b"IDAT" else body]
                  for kind, body in chunks]
    elif choice == 6:
        random.shuffle(chunks)
    elif choice == 7:
        chunks[1:1] = [[b"iTXt", note + b"\0\0\0\0\0" + random.choice(
            [b"{", b"[]", b'{"scene": "input.png"}', b'{"projection": {"near": -1}}', b"\xff" * 100])]]
    whole = data[:8] + b"".join(chunk(*each) for each in chunks)
    if choice == 8:
        bad = bytearray(whole)
        bad[random.randrange(8, len(bad))] ^= 1 << random.randrange(8)
        whole = bytes(bad)
    return broken_bytes(random, whole, 0.1)


def repeated_chunks(each, count):
    return [each] * min(count, MOST_BYTES // (len(each[1]) + 12))


def broken_figure(random, data):
    """Breaks an SVG or PDF: its state and its text."""
    kind = random.randrange(5)
    if kind == 0:
        return data.replace(b"{", random.choice([b"{{", b"[" * 100_000, b"{\"scene\": \"input.svg\","]), 1)
    if kind == 1:
        return data.replace(b"\n", b"\n" * random.choice([2, 10_000]), random.choice([1, 50]))
    if kind == 2:
        middle = len(data) // 2
        return data[:middle] + data[:middle] + data[middle:]
    return broken_bytes(random, data, 1.0)


def value_text(random):
    """A text for --set PATH= or an option's value."""
    kind = random.randrange(6)
    if kind == 0:
        return str(random.choice(NUMBERS))
    if kind == 1:
        return json.dumps(repeated(random.choice([0, 1.5, "a", [0, 0, 0]]), random.choice([0, 1, 2, 3, 4, 5, 17, 1_001, 9_000])))
    if kind == 2:
        return json.dumps({random.choice(["a", "objects", "position", "object"]): random.choice(NUMBERS + TEXTS)},
                          default=str)
    if kind == 3:
        return random.choice(LITERALS)
    if kind == 4:
        return "[" * random.choice([1, 500, 50_000])
    return random.choice(TEXTS)
