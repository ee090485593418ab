"""The laws of metals that a program has, with the parameters of its documentation, and metals drawn from them."""
import re
import subprocess

# What is drawn of each kind: where `deltaform --list` names the laws, where the scene chooses one.
KINDS = {
    "hardening": ("Material/Hardening/Law", "Material/Hardening/Law"),
    "yield surface": ("Material/Yield surface/Law", "Material/Yield surface/Law"),
    "backstress": ("Material/Backstress/Law", "Material/Backstress/Law"),
    "rate factor": ("Material/Rate factor/Law", "Material/Rate factor/Law"),
    "softening": ("", "Material/Heat/Softening"),
    "criterion": ("Limits/Criteria", "Limits/Criteria"),
    "curve": ("Limits/forming limit/Curve", "Limits/forming limit/Curve"),
}
SHELLS_ONLY = {"yld2000-2d", "thinning", "forming limit"}
# Entries of which a scene has some only; what the documentation's example leaves at a special value.
INSTEAD = {"hill": ["r0=1.6", "r90=0.8"], "hosford": ["Exponent=6", "r-bar=1.7"],
           "two-branch power": ["Initial flow stress=108", "First coefficient=556", "First exponent=0.504",
                                "Second coefficient=488", "Second exponent=0.375"]}  # the example has other units


def run(program, *words):
    return subprocess.run([program, *words], check=True, capture_output=True, text=True).stdout


class Laws:
    """names[kind]: laws; a law that is added to the program is among them."""

    def __init__(self, program):
        listed, section = {}, None
        for line in run(program, "--list").splitlines():
            if line and not line.startswith(" "):
                section = line.strip()
                listed[section] = []
            elif line.strip():
                listed[section].append(re.split(r"\s{2,}", line.strip())[0])
        self.examples = {}
        pages = run(program, "--print-parameters")
        for heading, body in re.findall(r"^## (.*)\n((?:(?!## ).*\n?)*)", pages, re.MULTILINE):
            self.examples[heading.strip()] = re.findall(r"^\| (.*?) \| required, e\.g\. `(.*?)`", body, re.MULTILINE)
        self.names = {kind: listed[where] for kind, (where, _) in KINDS.items() if where}
        page = re.search(r"^\| Softening \|.*?one of ([^|]*)\|", pages, re.MULTILINE)
        self.names["softening"] = [name.strip() for name in page[1].split(",")]
        self.names["criterion"].remove("forming limit")
        self.names["criterion"].remove("temperature rise")  # adiabatic metals have it by themselves
        self.names["criterion"] += ["forming limit by " + curve for curve in self.names.pop("curve")]

    def entries(self, kind, law, chance):
        """Choose the law; its parameters are up to a fifth off those of the documentation."""
        choice = KINDS[kind][1]
        if law in INSTEAD:
            own = [f"{choice.rsplit('/', 1)[0]}/{entry}" for entry in INSTEAD[law]]
        else:
            own = []
            heading = f"{choice}: {law}"
            for section, examples in self.examples.items():
                if section == heading or section.startswith(heading + "/"):
                    path = choice.rsplit("/", 1)[0] + section[len(heading):]
                    own += [f"{path}/{name}={self.drawn(value, chance)}" for name, value in examples]
        return [f"{choice}={law}", *own]

    @staticmethod
    def drawn(value, chance):
        try:
            return repr(float(value) * chance.uniform(.8, 1.2))
        except ValueError:
            return value  # a table


class Deal:
    """Metals with laws of all kinds, drawn until every law has been in one of a solid and in one of a shell."""

    def __init__(self, laws, chance):
        self.laws, self.chance = laws, chance
        # How a flow curve hardens is no history of its own: one blank is enough.
        self.shared = {"hardening": list(laws.names["hardening"])}

    def metals(self, blank):
        """Lists of entries, each with a sentence that names the laws."""
        names = {kind: [law for law in self.laws.names[kind]
                        if blank == "shell" or law.split(" by ")[0] not in SHELLS_ONLY] for kind in self.laws.names}
        names["heat"] = ["none", "adiabatic", "conduction" if blank == "solid" else "falling modulus"]
        rest = {kind: self.shared.get(kind, list(names[kind])) for kind in names}
        # Half of the flow curves are left for the second blank.
        least = {"hardening": len(rest["hardening"]) // 2 if blank == "solid" else 0}
        while any(len(rest[kind]) > least.get(kind, 0) for kind in rest):
            pick = {kind: self.chance.choice(rest[kind] or names[kind]) for kind in names}
            self.reconcile(pick)
            for kind, law in pick.items():
                if law in rest[kind]:
                    rest[kind].remove(law)
            yield ", ".join(f"{kind} {law}" for kind, law in pick.items() if law != "none"), self.scene(pick)

    @staticmethod
    def reconcile(pick):
        """What does not go together."""
        if pick["backstress"] == "yoshida-uemori":
            pick["hardening"] = "perfectly plastic"  # of its own size
        if pick["hardening"] == "flow curves":  # know the rate and the temperature themselves
            pick["rate factor"] = pick["softening"] = "none"
        if pick["heat"] not in ("adiabatic", "conduction"):
            pick["softening"] = "none"
        if pick["criterion"] == "forming limit by marciniak-kuczynski":  # of metals without rate and direction
            pick["rate factor"], pick["yield surface"] = "none", "mises"
            if pick["hardening"] == "flow curves":
                pick["hardening"] = "swift"

    def scene(self, pick):
        entries = []
        for kind in ("hardening", "yield surface", "backstress", "rate factor"):
            entries += self.laws.entries(kind, pick[kind], self.chance)
        if pick["backstress"] == "yoshida-uemori":
            size = next(entry for entry in entries if "/Yield stress=" in entry)
            entries = [entry for entry in entries if "/Flow stress=" not in entry]
            entries.append("Material/Hardening/Flow stress=" + size.split("=")[1])
        if pick["heat"] in ("adiabatic", "conduction"):
            # A small capacity, so that the temperature matters
            entries += ["Material/Heat/Adiabatic=true", "Material/Heat/Heat capacity=0.3"]
            entries += self.laws.entries("softening", pick["softening"], self.chance)
        if pick["heat"] == "conduction":
            entries += ["Material/Heat/Conductivity=0.2", "Heat/Names=air", "Heat/air/Boundaries=start, top",
                        "Heat/air/Film coefficient=0.5", "Heat/air/Temperature=20"]
            entries = [entry for entry in entries if "/Initial temperature=" not in entry]
            entries.append("Material/Heat/Initial temperature=25")
            if pick["hardening"] == "flow curves":
                entries.append("Material/Hardening/Initial temperature=25")
        if pick["heat"] == "falling modulus":
            entries += ["Material/Falling modulus/Saturated modulus=50000", "Material/Falling modulus/Rate=60"]
        criterion, *curve = pick["criterion"].split(" by ")
        entries.append("Limits/Criteria=" + criterion)
        for law in curve:
            entries += self.laws.entries("curve", law, self.chance)
        return entries
