"""Changes of texts as accidents and malice make them. Everything is drawn from a random.Random, so that a seed is a case."""
import re

NUMBER = re.compile(r"(?<![\w.])[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?(?![\w.])")

EXTREMES = ("0", "-0", "-1", "1", "1e-300", "1e300", "-1e300", "1e160", "1e-160", "1e308", "1e400", "5e-324", "1e-20", "1e20",
            "-1e-3", "1e-13", "1e13", "2147483647", "2147483648", "4294967296", "-2147483648", "1000000", "9999999999999999999",
            "nan", "inf", "-inf", "0/0", "1/0", "sqrt(-1)", "log(0)", "1e", ".", "0x10", "1,5", "")

FUNCTIONS = ("t", "-t", "1/t", "1/(t-.37)", "log(t)", "sqrt(.5-t)", "if(abs(t-.5025)<.002,0/0,t)", "0: 0, 1: 1", "0: 1, 0: 2",
             "1: 0, .5: 1", "0: 1e300, 1: -1e300", "t<.5 ? 1 : nan", "exp(1e3*t)", "pow(t,-3)", "auto", "-auto", "thickness",
             "0*thickness", "R*Z", "sin(1e9*t)", "0: 1e-3, .495: 1e-3, .5: 0, .505: 1e-3", "((((t))))", "t+", "(", "rnd", "t=1")

WORDS = ("true", "false", "all", "none", "a/b", "..", "-", "'", "\"", "\\", "#", "=", "end", "include /dev/zero",
         "subsection X", "\x00", "\x1b[2J", "\xff\xfe", "\u00e9\u4e2d", "a" * 300, "a," * 2000, "<x>&amp;", "%s%n")


def number(chance, text):
    """One number becomes an extreme one, or is scaled."""
    places = list(NUMBER.finditer(text))
    if not places:
        return text
    place = chance.choice(places)
    if chance.random() < .3:
        factor = chance.choice((1e-9, 1e-6, 1e-3, .1, .5, 2., 10., 1e3, 1e6, 1e9, -1.))
        new = repr(float(place.group()) * factor)
    else:
        new = chance.choice(EXTREMES)
    return text[:place.start()] + new + text[place.end():]


def lines(chance, text):
    """Lines vanish, come twice, change places, or are cut."""
    parts = text.split("\n")
    i, k = chance.randrange(len(parts)), chance.randrange(len(parts))
    kind = chance.randrange(5)
    if kind == 0:
        del parts[i]
    elif kind == 1:
        parts.insert(k, parts[i])
    elif kind == 2:
        parts[i], parts[k] = parts[k], parts[i]
    elif kind == 3:
        parts[i] = parts[i][:chance.randrange(len(parts[i]) + 1)]
    else:
        parts = parts[:i]
    return "\n".join(parts)


def characters(chance, text):
    """Some characters become others."""
    result = list(text)
    for _ in range(chance.choice((1, 1, 2, 5, 30))):
        if result:
            result[chance.randrange(len(result))] = chr(chance.choice((chance.randrange(256), chance.randrange(32, 127))))
    return "".join(result)


def value(chance, text):
    """The value of an entry becomes that of another, a function, or a word."""
    entries = list(re.finditer(r"(?m)^(\s*set [^=\n]*=)([^\n#]*)", text))
    if not entries:
        return text
    entry = chance.choice(entries)
    new = chance.choice((chance.choice(entries).group(2), " " + chance.choice(FUNCTIONS), " " + chance.choice(FUNCTIONS),
                         " " + chance.choice(WORDS), " " + chance.choice(EXTREMES)))
    return text[:entry.start(2)] + new + text[entry.end(2):]


def structure(chance, text):
    """Subsections within one another, many entries, long names, includes."""
    where = chance.randrange(len(text) + 1)
    where = text.find("\n", where) + 1
    n = chance.choice((3, 30, 3000))
    new = chance.choice((
        "".join(f"subsection s{i}\n" for i in range(n)) + "end\n" * chance.choice((n, n - 1)),
        "".join(f"set Unknown {i} = {i}\n" for i in range(n)),
        "set " + "x" * n * 10 + " = 1\n", "subsection " + "y" * n * 10 + "\nend\n",
        "include /dev/zero\n", "include .\n", "include nowhere.prm\n", "include " + "z" * n + "\n",
        "set Title = " + "t" * n * 10 + "\n", "end\n", "set A = " + "(" * n + "1" + ")" * n + "\n"))
    return text[:where] + new + text[where:]


class Vocabulary:
    """What scenes are made of: every entry with the values that scenes give it, and whole subsections."""

    def __init__(self, texts):
        self.values, self.blocks = {}, []
        for text in texts:
            for name, value in re.findall(r"(?m)^\s*set ([^=\n]*?)\s*=([^\n#]*)", text):
                self.values.setdefault(name, []).append(value)
            self.blocks += re.findall(r"(?m)^subsection [^\n]*\n(?:.*\n)*?end$", text)
        self.names = sorted(self.values)


def statement(chance, text, vocabulary):
    """An entry gets the value that another scene gives it, the value of another entry, or stands where it does not belong."""
    entries = list(re.finditer(r"(?m)^(\s*set )([^=\n]*?)(\s*=)([^\n#]*)", text))
    if not entries:
        return text
    entry, kind = chance.choice(entries), chance.randrange(5)
    known = vocabulary.values.get(entry.group(2), [entry.group(4)])
    any_value = chance.choice(vocabulary.values[chance.choice(vocabulary.names)])
    if kind < 2:
        return text[:entry.start(4)] + chance.choice(known) + text[entry.end(4):]
    if kind == 2:
        return text[:entry.start(4)] + any_value + text[entry.end(4):]
    if kind == 3:
        name = chance.choice(vocabulary.names)
        new = entry.group(1) + name + " = " + chance.choice(vocabulary.values[name]) + "\n"
        return text[:entry.start()] + new + text[entry.start():]
    return text[:entry.start(2)] + chance.choice(vocabulary.names) + text[entry.end(2):]


def block(chance, text, vocabulary):
    """A subsection vanishes, comes twice, comes from another scene, or gets another name."""
    parts = list(re.finditer(r"(?m)^( *)subsection ([^\n]*)\n(?:.*\n)*?\1end$", text))
    if not parts:
        return text
    part, kind = chance.choice(parts), chance.randrange(4)
    if kind == 0:
        return text[:part.start()] + text[part.end():]
    if kind == 1:
        return text[:part.end()] + "\n" + part.group() + text[part.end():]
    if kind == 2:
        return text[:part.start()] + chance.choice(vocabulary.blocks) + text[part.end():]
    return text[:part.start(2)] + chance.choice((chance.choice(parts).group(2), "a b", "x" * 201, "\u00e9")) + text[part.end(2):]


def listed(chance, text, vocabulary):
    """Lists, rows of points, tables and names: one of their members vanishes, comes twice, changes places, is empty."""
    del vocabulary
    places = list(re.finditer(r"(?m)^\s*set [^=\n]*=([^\n#]*[,;:][^\n#]*)", text))
    if not places:
        return text
    place = chance.choice(places)
    mark = chance.choice([c for c in ",;:" if c in place.group(1)])
    members, kind = place.group(1).split(mark), chance.randrange(6)
    i, k = chance.randrange(len(members)), chance.randrange(len(members))
    if kind == 0:
        del members[i]
    elif kind == 1:
        members.insert(k, members[i])
    elif kind == 2:
        members[i], members[k] = members[k], members[i]
    elif kind == 3:
        members[i] = ""
    elif kind == 4:
        members[i] = " " + chance.choice(EXTREMES + FUNCTIONS)
    else:
        members = members * chance.choice((2, 100, 3000))
    return text[:place.start(1)] + mark.join(members) + text[place.end(1):]


def measured(chance, text, vocabulary):
    """Numbers get units, percents and products; lengths become multiples of others."""
    del vocabulary
    places = list(NUMBER.finditer(text))
    if not places:
        return text
    place = chance.choice(places)
    old = place.group()
    new = chance.choice((old + " mm", old + " in", old + "%", old + " %", old + "*thickness", "thickness/" + old, old + "/0",
                         old + "^" + old, old + "*t", "(" + old + ")", "-" + old, old + "e" + old, old + " " + old, "+" + old,
                         old + "*(1+1e-15)", "auto", "infinity"))
    return text[:place.start()] + new + text[place.end():]


def included(chance, text, vocabulary):
    """What other files say comes before, after or in the middle: here as the text of whole scenes."""
    other = chance.choice(vocabulary.blocks)
    where = text.find("\n", chance.randrange(len(text) + 1)) + 1
    return chance.choice((other + "\n" + text, text + "\n" + other + "\n", text[:where] + other + "\n" + text[where:],
                          text.replace("\n", "\r\n"), text.replace("\n", " \\\n"), text.replace("  set", "\tset")))


def scene(chance, text, vocabulary):
    """A scene with one to four changes: some know the language of scenes, the others are blind."""
    knowing, blind = (statement, statement, statement, block, listed, measured, included), (number, number, value, value, lines,
                                                                                           characters, structure)
    for _ in range(chance.choice((1, 1, 1, 2, 3, 4))):
        if chance.random() < .6:
            text = chance.choice(knowing)(chance, text, vocabulary)
        else:
            text = chance.choice(blind)(chance, text)
    if chance.random() < .02:
        text = chance.choice(("\ufeff", "\xff\xfe", "\x00")) + text
    return text


def mesh(chance, text):
    """A mesh file with one to three changes."""
    for _ in range(chance.choice((1, 1, 1, 2, 3))):
        text = chance.choice((number, number, number, lines, lines, characters))(chance, text)
    return text


def content(chance, data):
    """Bytes of a saved state: flipped, set to extremes, cut, repeated."""
    data = bytearray(data)
    for _ in range(chance.choice((1, 1, 2, 8))):
        i = chance.randrange(len(data))
        kind = chance.randrange(5)
        if kind == 0:
            data[i] ^= 1 << chance.randrange(8)
        elif kind == 1:
            data[i:i + 8] = chance.choice((b"\xff" * 8, b"\0" * 8, b"\0" * 6 + b"\xf0\x7f", b"\0\0\0\0\x01\0\0\0"))
        elif kind == 2:
            data = data[:max(1, i)]
        elif kind == 3:
            data[i:i] = data[i:i + chance.choice((1, 8, 64))]
        else:
            del data[i:i + chance.choice((1, 8, 64))]
        data = data or bytearray(b"\0")
    return bytes(data)
