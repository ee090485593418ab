"""Tables of the solid blank for benchmarks.py: errors and orders against closed forms and published values."""
import math

import shell_and_solid

TWO_ACROSS = "Blank/Elements through thickness=2"


def cells_of(degree, n):
    return ["Blank/Degree=%d" % degree, "Blank/Elements=%d" % n, "Blank/Elements through thickness=%d" % n]


def sphere(pressure, a=100., b=200., young=210e3, nu=.3, s=240.):
    """Outer displacement of the elastic-plastic thick sphere under pressure, and after elastic unloading (Hill 1950)."""
    low, high = a, b
    for _ in range(200):
        c = .5 * (low + high)
        if 2 * s * math.log(c / a) + 2 * s / 3 * (1 - (c / b) ** 3) < pressure:
            low = c
        else:
            high = c
    loaded = (1 - nu) * s * c ** 3 / (young * b ** 2)
    return loaded, loaded - 3 * (1 - nu) * pressure * a ** 3 * b / (2 * young * (b ** 3 - a ** 3))


def cylinder_stress(a, flow=500., a0=10., b0=20.):
    x = (a / a0) ** 2
    return flow / math.sqrt(3) * math.log(x / ((b0 / a0) ** 2 + x - 1))


def at(rows, column, value):
    return min(rows, key=lambda row: abs(row[column] - value))


def make(table_of, series):
    def by_mesh(run, scene, sizes, quantities, floor=0., extra=(), mesh=cells_of):
        """Quantities: (title, file, function of rows, reference)."""
        rows = []
        for degree in (1, 2):
            errors = [[] for _ in quantities]
            for n in sizes:
                tables = run(scene, [q[1] for q in quantities], *mesh(degree, n), *extra)
                for i, (_, _, value, reference) in enumerate(quantities):
                    errors[i].append(value(tables[i]) / reference - 1 if tables else None)
            columns = [series(sizes, e, floor) for e in errors]
            rows += [[str(degree), str(n)] + [column[i] for column in columns] for i, n in enumerate(sizes)]
        return table_of(["degree", "elements each way"] + [q[0] for q in quantities], rows)

    def thick_sphere(run):
        loaded, unloaded = sphere(250.)
        return by_mesh(run, "thick_sphere", (4, 8, 16, 32),
                       [("u_b, P = 250", "profile_1.csv", lambda rows: rows[0]["u_r_bottom"], loaded),
                        ("u_b, unloaded", "profile_2.csv", lambda rows: rows[0]["u_r_bottom"], unloaded)])

    def thick_cylinder(run, alone=False):
        quantities = [("a = %d" % a, "history.csv",
                       lambda rows, a=a: -at(rows, "wall_travel", a - 10.)["wall_force_r"] / (2 * math.pi * a),
                       -cylinder_stress(a)) for a in (20, 40, 85)]
        mesh = lambda degree, n: ["Blank/Degree=%d" % degree, "Blank/Elements=%d" % n]
        if not alone:
            return by_mesh(run, "thick_cylinder", (5, 10, 20, 40), quantities, 1e-1, mesh=mesh)
        # The error of the mesh alone: elastic strains and increments are the same on all.
        finest = run("thick_cylinder", "history.csv", *mesh(2, 80))
        return by_mesh(run, "thick_cylinder", (5, 10, 20, 40),
                       [("mesh alone, " + title, file, value, value(finest)) for title, file, value, _ in quantities],
                       1e-8, mesh=mesh)

    def necking(run):
        rows = []
        for degree, along, across in ((1, 10, 5), (1, 20, 10), (1, 40, 20), (2, 10, 5), (2, 20, 10)):
            for increment in (.04, .01):
                table = run("necking", "history.csv", "Blank/Degree=%d" % degree, "Blank/Elements=%d" % along,
                            "Blank/Elements through thickness=%d" % across,
                            "Steps/pull/Largest increment=%g" % increment)
                rows.append([str(degree), "%d x %d" % (along, across), "%g" % increment,
                             "%.3f (%.1e)" % (table[-1]["pull_reaction"] / 1e3, table[-1]["pull_reaction"] / 75678. - 1),
                             "%.4f (%.1e)" % (table[-1]["min_thickness"] / 6.413,
                                              table[-1]["min_thickness"] / 6.413 / .9426 - 1),
                             "%.0e" % abs(table[-1]["energy_error"])])
        return table_of(["degree", "elements", "increment", "force (kN), error", "r/R, error", "energy balance"], rows)

    def upsetting(run):
        rows = []
        for friction in ("0", "0.1", "10"):
            for degree, n in ((1, 5), (1, 10), (1, 20), (2, 5), (2, 10)):
                table = run("upsetting", "history.csv", "Blank/Degree=%d" % degree, "Blank/Elements=%d" % n,
                            "Blank/Elements through thickness=%d" % (3 * n // 2),
                            "Tools/die/Friction coefficient=" + friction)
                force = ["%.2f" % (at(table, "die_travel", travel)["die_force_z"] / 1e3) for travel in (6., 9.)] \
                    if table else ["failed"] * 2
                rows.append([friction, str(degree), "%d x %d" % (n, 3 * n // 2)] + force +
                            [str(int(sum(row["newton_iterations"] for row in table))) if table else "",
                             str(int(sum(row["cutbacks"] for row in table))) if table else ""])
        return table_of(["mu", "degree", "elements", "kN at 40 %", "kN at 60 %", "Newton iterations", "cutbacks"], rows)

    def stretching(run):
        rows = []
        for mu in ("0", "0.15"):
            friction = ["Tools/punch/Friction coefficient=" + mu, "Tools/die/Friction coefficient=" + mu]
            files = ["history.csv", "profile_40.csv"]
            solid = run("osu_stretching_solid", files, "Blank/Elements=160", TWO_ACROSS, *friction)
            reference = [at(solid[0], "punch_travel", t)["punch_force_z"] for t in (20., 40.)]

            def strain(place):
                row = min(solid[1], key=lambda r: abs(r["R0"] - place))
                after = [r for r in solid[1] if r["R0"] >= place][0]
                before = [r for r in solid[1] if r["R0"] <= place][-1]
                if after is before:
                    return row["eps_thickness"]
                share = (place - before["R0"]) / (after["R0"] - before["R0"])
                return before["eps_thickness"] + share * (after["eps_thickness"] - before["eps_thickness"])

            for title, scene, sets in (
                    ("solid, degree 2, 160 x 2", None, ()),
                    ("solid, degree 2, 80 x 2", "osu_stretching_solid", ("Blank/Elements=80", TWO_ACROSS)),
                    ("solid, degree 1, 200 x 4", "osu_stretching_solid",
                     ("Blank/Degree=1", "Blank/Elements=200", "Blank/Elements through thickness=4")),
                    ("shell, 200", "osu_stretching", ("Blank/Elements=200",)),
                    ("shell, 200, no transverse normal stress", "osu_stretching",
                     ("Blank/Elements=200", "Blank/Transverse normal stress=false"))):
                table = solid if scene is None else run(scene, files, *sets, *friction)
                force = [at(table[0], "punch_travel", t)["punch_force_z"] for t in (20., 40.)]
                worst = [max(abs(r["eps_thickness"] - strain(r["R0"])) for r in table[1] if low <= r["R0"] < 50.)
                         for low in (0., 2.)]
                rows.append([mu, title] + ["%.2f (%+.2f %%)" % (f / 1e3, 100 * (f / g - 1))
                                           for f, g in zip(force, reference)] + ["%.4f" % w for w in worst])
        return table_of(["mu", "blank", "kN at 20 mm", "kN at 40 mm", "thickness strain, r < 50", "2 < r < 50"], rows)

    def published(run):
        """Forces at the published travels, which the runs hit exactly."""
        rows = []
        travels = "Output/Travels=" + ", ".join("%g" % travel for _, travel in shell_and_solid.PUBLISHED)
        tables = [run(scene, "history.csv", travels, *sets) for scene, sets in (
            ("osu_stretching", ("Blank/Elements=200",)),
            ("osu_stretching", ("Blank/Elements=200", "Blank/Transverse normal stress=false")),
            ("osu_stretching_solid", ("Blank/Elements=80", TWO_ACROSS)))]
        for force, travel in shell_and_solid.PUBLISHED:
            computed = [at(table, "punch_travel", travel)["punch_force_z"] for table in tables]
            rows.append(["%.1f" % travel, "%g" % (force / 1e3)] +
                        ["%.2f (%+.1f %%)" % (value / 1e3, 100 * (value / force - 1)) for value in computed])
        return table_of(["mm", "published", "shell, 200", "shell, 200, no transverse normal stress",
                         "solid, degree 2, 80 x 2"], rows)

    def cup_models(run):
        rows = []
        for title, scene, sets in (
                ("shell, 50", "cup", ()), ("shell, 400", "cup", ("Blank/Elements=400",)),
                ("solid, degree 2, 100 x 2", "cup_solid", ()),
                ("solid, degree 2, 200 x 2", "cup_solid", ("Blank/Elements=200",)),
                ("solid, degree 1, 200 x 4", "cup_solid",
                 ("Blank/Degree=1", "Blank/Elements=200", "Blank/Elements through thickness=4"))):
            table = run(scene, ["history.csv", "profile_0.6.csv", "profile_1.csv"], "Output/Travels=0.6, 1", *sets)
            if not table:
                rows.append([title] + ["failed"] * 4)
                continue
            rows.append([title] + ["%.4f" % at(table[0], "punch_travel", t)["punch_force_z"] for t in (.6, 1.)] +
                        ["%.4f" % min(r["eps_thickness"] for r in table[2]),
                         "%.4f" % (2.22 - table[2][-1]["r"])])
        return table_of(["blank", "tonf at .6 in", "tonf at 1 in", "smallest thickness strain", "draw-in (in)"], rows)

    def patch(run):
        rows = []
        contacts = (("active set", ("Contact/Enforcement=active set",)),
                    ("augmented Lagrangian, gaps to 1e-12 delta", ("Contact/Enforcement=augmented Lagrangian",
                                                                  "Contact/Augmentation tolerance=1e-12")),
                    ("constant per area", ("Contact/Enforcement=penalty", "Contact/Penalty rule=constant",
                                           "Contact/Penalty factor=1e4", "Contact/Penalty factor is=per area")),
                    ("constant per node", ("Contact/Enforcement=penalty", "Contact/Penalty rule=constant",
                                           "Contact/Penalty factor=1e4")),
                    ("adaptive", ("Contact/Enforcement=penalty",)))
        for title, sets in contacts:
            for mesh, grading in (("uniform", "1"), ("graded 1:20", "0: 1, 1: 20")):
                cells = []
                for degree in (1, 2):
                    table = run("contact_patch", "contact_1.csv", "Blank/Degree=%d" % degree,
                                "Blank/Grading=" + grading, "Solver/Force tolerance=1e-12", *sets)
                    worst = max(abs(row["pressure"] / 10. - 1) for row in table) if table else float("nan")
                    cells.append("< 1e-9" if worst < 1e-9 else "%.1e" % worst)
                rows.append([title, mesh] + cells)
        return table_of(["contact", "mesh", "degree 1", "degree 2"], rows)

    def hertz(run):
        rows = []
        force, pressure = 4. / 3. * 1000 / .91 * math.sqrt(200.) * .005 ** 1.5, 2 * 1000 / .91 / (math.pi * 200.)
        line = 2.747253
        for degree in (1, 2):
            errors = [[], [], [], []]
            sizes = (20, 40, 80) if degree == 1 else (10, 20, 40)
            for n in sizes:
                ball = run("hertz_sphere", ["history.csv", "contact_0.005.csv"], *cells_of(degree, n))
                cylinder = run("hertz_line", "contact_1.csv", *cells_of(degree, n))
                punch = run("flat_punch", "history.csv", *cells_of(degree, n))
                errors[0].append(ball[0][-1]["sphere_force_z"] / force - 1 if ball else None)
                errors[1].append(ball[1][0]["pressure"] / pressure - 1 if ball else None)
                errors[2].append(cylinder[0]["pressure"] / line - 1 if cylinder else None)
                errors[3].append(punch[-1]["punch_force_z"] / (2 / .91 * .01) - 1 if punch else None)
            columns = [series(sizes, e, 1e-3 if i < 3 else 0.) for i, e in enumerate(errors)]
            rows += [[str(degree), str(n)] + [column[i] for column in columns] for i, n in enumerate(sizes)]
        return table_of(["degree", "elements each way", "11: F, sphere", "11: p0, sphere", "12: p0, cylinder",
                         "13: F, flat punch"], rows)

    def delta(run):
        """What the allowed penetration adds to the force of a mesh, and what the mesh itself is off by."""
        exact, rows = 4. / 3. * 1000 / .91 * math.sqrt(200.) * .005 ** 1.5, []
        cases = ("2e-5", "1e-6", "auto")
        for degree, sizes in ((1, (10, 20, 40, 80)), (2, (5, 10, 20, 40))):
            for n in sizes:
                tables = [run("hertz_sphere", "history.csv", *cells_of(degree, n))] + [
                    run("hertz_sphere", "history.csv", "Contact/Enforcement=penalty", "Contact/Allowed penetration=" + d,
                        *cells_of(degree, n)) for d in cases]
                held = tables[0][-1]["sphere_force_z"]
                rows.append([str(degree), str(n), "%.1e" % (held / exact - 1)])
                for table in tables[1:]:
                    rows[-1] += ["%.1e, %.1e" % (table[-1]["max_penetration"], table[-1]["sphere_force_z"] / held - 1)] \
                        if table else ["failed"]
        return table_of(["degree", "elements each way", "mesh: F, active set"] +
                        ["delta = %s: p, F" % d for d in cases], rows)

    def greco(run):
        published, rows = (28.6, 27.2, 22.8, 19.8, 15.0), [["published", ""] + ["28.6", "27.2", "22.8", "19.8", "15.0"]]
        for degree, n in ((1, 32), (1, 64), (2, 32)):
            table = run("greco", "profile_1.csv", *cells_of(degree, n))
            rows.append([str(degree), str(n)] + ["%.2f" % (1e3 * at(table, "R0", x)["u_r_bottom"])
                                                 for x in (0., 1.25, 5., 7.5, 11.25)])
        return table_of(["degree", "elements each way", "x = 0", "1.25", "5", "7.5", "11.25"], rows)

    def indentation(run):
        rows = []
        for degree, n in ((1, 25), (1, 50), (2, 25)):
            table = run("indentation", "history.csv", "Blank/Degree=%d" % degree, "Blank/Elements=%d" % n,
                        "Blank/Elements through thickness=%d" % (4 * n // 5))
            rows.append([str(degree), str(n)] +
                        ["%.4g" % (at(table, "sphere_travel", d)["sphere_force_z"] / (2 * math.pi * d))
                         for d in (.5, 1.)] if table else [str(degree), str(n), "failed", "failed"])
        return table_of(["degree", "elements", "F/(2 pi d), d = .5", "d = 1"], rows)

    ungraded = ["Blank/Grading=1", "Blank/Grading through thickness=1", "Steps/press/First increment=1",
                "Steps/press/Largest increment=1", "Solver/Largest rotation increment=10"]

    def refined(passes, *more):
        return ["Blank/Refinement/Criterion=recovery", "Blank/Refinement/Passes=%d" % passes,
                "Blank/Refinement/Maximal level=10", "Blank/Refinement/Contact rim=true",
                "Blank/Refinement/Contact edges=0"] + list(more)

    def half_space(run):
        """The mesh of 10 x 10 equal cells of degree 2, refined everywhere or where the error is."""
        rows = []
        for title, scene, tool, label, force, pressure in (
                ("11: sphere", "hertz_sphere", "sphere", "contact_0.005.csv", 4. / 3. * 1000 / .91 * math.sqrt(200.) * .005 ** 1.5,
                 lambda r: 2 * 1000 / .91 / (math.pi * 200.) * math.sqrt(1 - r * r)),
                ("13: flat punch", "flat_punch", "punch", "contact_0.01.csv", 2 / .91 * .01,
                 lambda r: .01 / .91 / math.pi / math.sqrt(1 - r * r))):
            for mesh, count, sets in (
                    [("uniform", n, ["Blank/Elements=%d" % n, "Blank/Elements through thickness=%d" % n,
                                     "Solver/Linear solver=mumps"]) for n in (20, 40, 80, 160)] +
                    [("refined", k, ["Blank/Elements=10", "Blank/Elements through thickness=10"] + refined(k))
                     for k in (4, 6, 8, 10, 12)]):
                tables = run(scene, ["history.csv", label], *ungraded, *sets)
                if not tables or not tables[1]:
                    rows.append([title, "%s, %d" % (mesh, count), "", "none" if tables else "failed", "", "", ""])
                    continue
                last, first = tables[0][-1], tables[1][0]
                unknowns = int(last["unknowns"]) if "unknowns" in last else 2 * (2 * count + 1) ** 2 + 2 * count + 1
                mean = [abs(row["pressure"] / pressure(row["R0"]) - 1) for row in tables[1] if row["R0"] < .7]
                rows.append([title, mesh + (", %d x %d" % (count, count) if mesh == "uniform" else ", %d times" % count),
                             str(unknowns), str(int(last["contact_pairs"])), "%.1e" % (last[tool + "_force_z"] / force - 1),
                             "%.1e" % (first["pressure"] / pressure(first["R0"]) - 1) if mean else "",
                             "%.1e" % (sum(mean) / len(mean)) if mean else ""])
        return table_of(["problem", "mesh", "unknowns", "nodes in contact", "force", "innermost pressure",
                         "mean error of p, r < .7"], rows)

    def half_space_delta(run):
        """The sphere on refined meshes with penalty: delta fixed, and delta of the mesh."""
        rows = []
        force = 4. / 3. * 1000 / .91 * math.sqrt(200.) * .005 ** 1.5
        for delta in ("1e-4", "1e-5", "1e-6", "auto", "active set"):
            contact = ["Contact/Enforcement=active set"] if delta == "active set" else \
                ["Contact/Enforcement=penalty", "Contact/Allowed penetration=" + delta]
            tables = run("hertz_sphere", ["history.csv", "contact_0.005.csv"], *ungraded, "Blank/Elements=10",
                         "Blank/Elements through thickness=10", *refined(10), *contact)
            if not tables:
                rows.append([delta] + ["failed"] * 5)
                continue
            mean = [abs(row["pressure"] / (2 * 1000 / .91 / (math.pi * 200.) * math.sqrt(1 - row["R0"] ** 2)) - 1)
                    for row in tables[1] if .1 < row["R0"] < .7]
            rows.append([delta] + ["%.1e" % (tables[0][k]["sphere_force_z"] / force - 1) for k in (4, 6, 8, 10)] +
                        ["%.1e" % tables[0][-1]["max_penetration"], "%.1e" % (sum(mean) / len(mean)),
                         str(int(sum(row["newton_iterations"] for row in tables[0])))])
        return table_of(["delta", "force, refined 4 times", "6 times", "8 times", "10 times", "p",
                         "mean error of the pressure, .1 < r < .7", "Newton iterations"], rows)

    def stretching_refined(run):
        """OSU stretching, the mesh refined during the run; delta fixed and delta of the mesh."""
        rows = []
        for delta in ("1e-3*edge", "auto"):
            reference = None
            for title, sets in (
                    ("160 x 2", ["Blank/Elements=160"]), ("80 x 2", ["Blank/Elements=80"]),
                    ("40 x 2", ["Blank/Elements=40"]),
                    ("40 x 2, refined twice", ["Blank/Elements=40", "Blank/Refinement/Criterion=recovery",
                                               "Blank/Refinement/Every=5", "Blank/Refinement/Maximal level=2",
                                               "Blank/Refinement/Error share=0.3"]),
                    ("40 x 2, contact twice", ["Blank/Elements=40", "Blank/Refinement/Criterion=contact",
                                               "Blank/Refinement/Every=5", "Blank/Refinement/Maximal level=2",
                                               "Blank/Refinement/Contact edges=.08"])):
                table = run("osu_stretching_solid", "history.csv", TWO_ACROSS, *sets, "Contact/Allowed penetration=" + delta)
                if not table:
                    rows.append([delta, title] + ["failed"] * 6)
                    continue
                force = [at(table, "punch_travel", t)["punch_force_z"] for t in (20., 40.)]
                reference = reference or force
                unknowns = int(table[-1]["unknowns"]) if "unknowns" in table[-1] else \
                    10 * (2 * int(title.split()[0]) + 1)
                rows.append([delta, title, str(unknowns)] +
                            ["%.2f (%+.2f %%)" % (f / 1e3, 100 * (f / g - 1)) for f, g in zip(force, reference)] +
                            ["%.1e" % table[-1]["max_penetration"], "%.1e" % table[-1]["max_penetration_between_nodes"],
                             "%.1e" % abs(table[-1]["energy_error"])])
        return table_of(["delta", "elements", "unknowns", "kN at 20 mm", "kN at 40 mm", "p", "p between nodes",
                         "energy balance"], rows)

    return {"thick sphere": thick_sphere, "thick cylinder": thick_cylinder,
            "thick cylinder mesh": lambda run: thick_cylinder(run, True), "necking": necking, "upsetting": upsetting,
            "stretching": stretching, "stretching published": published,
            "cup models": cup_models, "contact patch": patch, "hertz": hertz, "delta": delta, "greco": greco,
            "indentation": indentation, "half space": half_space, "half space delta": half_space_delta,
            "stretching refined": stretching_refined}
