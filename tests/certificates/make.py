#!/usr/bin/python3
"""make.py FOLDER: writes the certificates that the checkers are tested with to the folder, with a solver of its own in
fractions: what is tested has no part in them. The build makes them, in tests/certificates of its folder.

Each test is a gradation (.csv or .json) and a certificate (.proof); the folder says the verdict: accepted, rejected or
unparsable. The folder blends has those of blends, by blends.py, the folder samples those of samples, by sample_cases.py.
"""
import heapq
import math
import pathlib
import shutil
import sys
from decimal import Decimal, localcontext
from fractions import Fraction as F
from itertools import count

import blends
import sample_cases
from exact import decimal, enclose, floor_root, root
from trees import Tree
from windows import WindowTree

if len(sys.argv) != 2:
    sys.exit("make.py FOLDER")
FOLDER = pathlib.Path(sys.argv[1])
PI = ("3.14159265358979323846", "3.14159265358979323847")


def names(text, power, d):
    """Whether a decimal is the opening with this power, or it rounded to the 15 digits of the decimal."""
    with localcontext() as context:
        context.prec = 60
        opening = Decimal(power.numerator) / Decimal(power.denominator)
        near = (opening.ln() / d).exp() if opening else opening
        context.prec = 15
        return F(text)**d == power or F(text) == F(+near)


def half(*phis):
    """Openings 2^-phi to the power d, and d."""
    phis = [F(v) if v != "pan" else v for v in phis]
    d = math.lcm(*(v.denominator for v in phis if v != "pan"))
    return [F(0) if v == "pan" else F(2)**int(-v * d) for v in phis], d


class Case:
    """A gradation x, m, c (decimals in texts) and a question: its least match and the certificate."""

    def __init__(self, x, m, c=None, law=(3, 1), pan=None, cut=None, factor=None, least=None, cylinder=None, box=None,
                 volume=None, at_least=None, scale="middle", places=12, extra=0, degree=1, steps=None):
        """Where the degree is d, x holds openings to the power d: the same gradation of them under the law a/(b d).
        With `steps` these are the first of the chain, which prove a bound."""
        self.d = d = degree
        self.law = law
        self.a, self.b = a, b = law[0], law[1] * d
        self.options = [f"{word} {value}" for word, value in
                        (("pan-size", pan), ("cut-below", cut), ("size-factor", factor), ("min-per-class", least),
                         ("cylinder", cylinder), ("box", box), ("solids-volume", volume)) if value]
        if box or volume:
            self.options.append("pi " + " ".join(PI))
        x, m = [F(v) for v in x], [F(v) for v in m]
        c = [F(v) for v in c] if c else [F(1)] * len(x)
        if pan:
            x[0] = F(pan)**d
        if cut:
            at = next(i for i, v in enumerate(x) if names(cut, v, d))
            x, m, c = (column[at:] for column in (x, m, c))
        x = [v * F(factor or 1)**d for v in x]
        self.x, self.m, self.c = x, m, c
        self.used = [j for j in range(len(x) - 1) if m[j] > 0]
        self.A = {j: c[j]**b * x[j]**a / m[j]**b for j in self.used}
        self.B = {j: c[j]**b * x[j + 1]**a / m[j]**b for j in self.used}
        self.r = {j: int(least or 1) for j in self.used}
        W = sum(m[j] / c[j] for j in self.used)
        self.S0 = F(0)
        if cylinder:
            D, H, e = map(F, cylinder.split())
            self.S0 = (3 * D * D * H / (2 * (1 + e) * W))**d
            self.r = {j: next(q for q in count(max(1, floor_root(self.S0 / self.B[j], d)), 1)
                              if q >= self.r[j] and q**d * self.B[j] >= self.S0) for j in self.used}
        if box or volume:
            sides = [F(v) for v in (box or volume + " 1 1 0").split()]
            V = sides[0] * sides[1] * sides[2] / (1 + sides[3])
            self.S0 = (6 * V / (F(PI[0]) * W))**d
            self.above((6 * V / (F(PI[1]) * W))**d)
        self.M, self.z = at_least, F(0)
        self.solve()
        if at_least and sum(self.q.values()) < at_least:
            if all(self.A.values()):
                self.z = self.breakpoint(at_least)
                self.above(self.z)
                self.solve()
        self.N = max(sum(self.q.values()), at_least or 0)
        self.steps = steps
        if steps is not None:
            self.cut_chain(steps)
        self.choose(scale, extra)
        assert steps is None or self.bound < self.N
        self.sizes = {j: enclose(self.S * self.m[j]**b / (self.q[j] * self.c[j])**b, a * d, self.x[j], self.x[j + 1],
                                 places, d) for j in self.used}

    def above(self, z):
        """Raises the floors to what a scale above z needs."""
        self.r = {j: max(self.r[j], self.count(j, z)) for j in self.used}

    def count(self, j, L):
        return max(self.r[j], floor_root(L / self.B[j], self.b) + 1)

    def solve(self):
        """The least fixed point: raises the class whose raise is the largest until nothing changes."""
        L, self.chain = F(0), []
        while True:
            best, j = max((self.count(j, L)**self.b * self.A[j], -j) for j in self.used)
            if best <= L:
                break
            L = best
            self.chain.append(-j)
        self.L, self.q = L, {j: self.count(j, L) for j in self.used}
        self.U = min(self.q[j]**self.b * self.B[j] for j in self.used)

    def cut_chain(self, steps):
        """Leaves the first steps, and the bound that they prove."""
        self.chain = self.chain[:steps]
        L = F(0)
        for j in self.chain:
            L = self.count(j, L)**self.b * self.A[j]
        self.bound = max(sum(self.count(j, L) for j in self.used), self.M or 0)

    def breakpoint(self, M):
        """The largest scale at which fewer than M particles fit: the M-th of the values q^b A_j."""
        heap = [(self.A[j], 1, j) for j in self.used]
        heapq.heapify(heap)
        for _ in range(M):
            z, q, j = heap[0]
            heapq.heapreplace(heap, ((q + 1)**self.b * self.A[j], q + 1, j))
        return z

    def choose(self, scale, extra):
        low = max(self.L, self.z)
        self.S = self.U if scale == "upper" or (low + self.U) / 2 < self.S0 else (low + self.U) / 2
        if self.d > 1 and self.S == self.U:  # which a size attains, and no decimal
            self.S = (self.S0 + self.U) / 2
        if scale == "start":
            self.S = self.S0
        missing = self.N - sum(self.q.values()) + extra
        for j in self.used:
            while missing > 0 and (self.q[j] + 1)**self.b * self.A[j] < self.S:
                self.q[j] += 1
                missing -= 1
        self.N += extra
        assert missing == 0

    def proof(self):
        shown = self.N if self.steps is None else self.bound
        lines = [f"mdm-certificate {1 if self.steps is None else 2}", f"law {F(*self.law)}", *self.options]
        if self.M:
            lines.append(f"at-least {self.M}")
        lines += [f"particles {self.N if self.steps is None else f'{shown}..{self.N}'}", f"scale {self.S}"]
        lines += [f"class {j + 1} {self.q[j]} {self.sizes[j][0]} {self.sizes[j][1]}" for j in self.used]
        if self.M != shown:
            if self.z:
                lines.append(f"above {self.z}")
            lines.append(" ".join(["chain", *(str(j + 1) for j in self.chain)]))
        return "\n".join(lines + ["end", ""])


def rows(header, *columns, delimiter=","):
    return "".join(delimiter.join(row) + "\n" for row in [header.split(","), *zip(*columns)])


SUITE_X = "0.0001 0.075 0.15 0.3 0.6 1.18 2.36 4.75 9.5 19 25 37.5 50 63 75".split()
SUITE_M = "3.86 1.2 0 10.1 14.84 20.5 13 11 9.5 7 4 2.9 1.5 0.6 0".split()
ATHABASCA_X = "0.02 0.038 0.076 0.106 0.15 0.25 0.3 0.425 0.85".split()
ATHABASCA_M = "0.5 3.86 5.74 14.1 43.2 14.6 11.4 6.6 0".split()
TRIPLE_X, TRIPLE_M = ["1", "2", "3"], ["2", "1", "0"]
NARROW_X = "1 1.01 1.02 1.03".split()
NARROW_M = "1 2 3 0".split()

accepted, rejected, unparsable = {}, {}, {}


def accept(name, gradation, case):
    accepted[name] = (gradation, case.proof())


def plain(name, x, m, **question):
    accept(name, rows("size_mm,mass", x, m), Case(x, m, **question))


plain("sphere_two_classes", TRIPLE_X, TRIPLE_M)
plain("sphere_suite", SUITE_X, SUITE_M)
plain("sphere_athabasca_upper", ATHABASCA_X, ATHABASCA_M, scale="upper")
plain("sphere_narrow", NARROW_X, NARROW_M)
plain("one_class", ["1", "2"], ["5", "0"])
plain("pan_alone", ["0", "2"], ["5", "0"])
plain("power_2", ATHABASCA_X, ATHABASCA_M, law=(2, 1))
plain("power_5_2", ATHABASCA_X, ATHABASCA_M, law=(5, 2))
plain("power_1_2", TRIPLE_X, TRIPLE_M, law=(1, 2), scale="upper")
plain("power_3_2", NARROW_X, NARROW_M, law=(3, 2))
plain("power_tie_of_roots", ["1", "2", "3"], ["1", "128", "0"], law=(7, 2), scale="upper")
plain("exact_sizes", ["1", "2", "4"], ["1", "8", "0"], scale="upper")
plain("exact_sizes_in_decimals", ["0.5", "1.5", "2.5"], ["3.375", "15.625", "0"], scale="upper")
plain("pan_at_zero", ["0", "0.075", "0.15"], ["3", "4", "0"])
plain("pan_size", ["0", "0.075", "0.15"], ["3", "4", "0"], pan="0.0001")
plain("pan_size_that_binds", ["0", "0.075", "0.076"], ["3", "4", "0"], pan="0.0745")
plain("cut_below", SUITE_X, SUITE_M, cut="0.3")
plain("size_factor", ATHABASCA_X, ATHABASCA_M, factor="5")
plain("pan_cut_factor", ["0", "1", "2", "4"], ["1", "2", "3", "0"], pan="0.5", cut="0.5", factor="2.5")
plain("interior_zeros", "1 2 3 4 5 6".split(), "3 0 2 0 1 0".split())
plain("min_per_class", ATHABASCA_X, ATHABASCA_M, least=10)
plain("cylinder", ATHABASCA_X, ATHABASCA_M, cylinder="5 2.4 0.683", places=18)
plain("cylinder_exactly_full", ["1", "2"], ["1", "0"], cylinder="7 3 0.5", scale="start")
plain("box", ATHABASCA_X, ATHABASCA_M, box="3 2.5 2 0.7", places=18)
plain("solids_volume", ATHABASCA_X, ATHABASCA_M, volume="12.5", places=18)
plain("solids_volume_and_min_per_class", TRIPLE_X, TRIPLE_M, volume="30", least=3)
plain("at_least_reached", ATHABASCA_X, ATHABASCA_M, at_least=20000, places=18)
plain("at_least_skips_a_gap", NARROW_X, ["5", "1", "0", "0"], at_least=27)
plain("at_least_of_a_least_match_above_it", ATHABASCA_X, ATHABASCA_M, at_least=100)
plain("at_least_with_a_pan", ["0", "1", "2"], ["1", "2", "0"], at_least=1000)
plain("at_least_power_3_2", NARROW_X, ["5", "1", "0", "0"], law=(3, 2), at_least=48)
plain("at_least_cylinder", NARROW_X, ["5", "1", "0", "0"], cylinder="3 2.5 0.5", at_least=30)
plain("at_least_everything", "0 1 1.1 1.2 1.3".split(), "1 2 7 4 0".split(), pan="0.9", cut="1", factor="1.5", least=2,
      cylinder="6 5 0.5", at_least=60)
# Bounds: a sweep that ended early.
plain("bounds_of_no_step", SUITE_X, SUITE_M, steps=0)
plain("bounds_of_some_steps", NARROW_X, NARROW_M, steps=5)
plain("bounds_of_a_match_that_is_not_the_smallest", ATHABASCA_X, ATHABASCA_M, steps=0, extra=2)
plain("bounds_of_a_whole_chain", TRIPLE_X, TRIPLE_M, steps=1, extra=1)
plain("bounds_power_3_2", NARROW_X, NARROW_M, law=(3, 2), steps=7)
plain("bounds_cylinder", NARROW_X, NARROW_M, cylinder="0.5 0.4 0.5", steps=9)
plain("bounds_solids_volume", NARROW_X, NARROW_M, volume="0.5", steps=11, places=18)
plain("bounds_min_per_class", NARROW_X, NARROW_M, least=4, steps=2)
plain("bounds_at_least_above_a_scale", NARROW_X, ["5", "1", "0", "0"], at_least=27, steps=0)
plain("bounds_at_least_without_a_chain", NARROW_X, NARROW_M, at_least=60, steps=0)
LARGE = 10**40
plain("large_integers", ["1", "1000000", "10000000"], [f"{LARGE + 7}", f"{LARGE + 9}", "0"])
plain("long_decimals", ["0." + "3" * 300, "0." + "6" * 300, "1"], ["1." + "7" * 200, "2", "0"])

x, m, c = ["1", "2", "3", "4"], ["3", "4", "5", "0"], ["2.65", "2.7", "0.5", "9"]
accept("factors", rows("size_mm,mass,factor", x, m, c), Case(x, m, c=c))
accept("factors_power_3_2_and_tolerance",
       rows("size_m,retained_g,tolerance_percent,factor", x, m, ["0", "1", "2", "3"], c), Case(x, m, c=c, law=(3, 2)))
accept("factors_solids_volume", rows("size_mm,mass,factor", x, m, c), Case(x, m, c=c, volume="1000"))
case = Case(TRIPLE_X, TRIPLE_M)
for header, values in (("size_um,retained_percent", TRIPLE_M), ("size_m,retained_fraction", TRIPLE_M)):
    accept(header.replace(",", "_"), rows(header, TRIPLE_X, values), case)
accept("descending_rows_with_comments", "# a sand\n\nsize_mm,mass\n3,0\n# the middle\n2,1\n \t\n1,2\n", case)
accept("byte_order_mark_and_crlf", "\ufeffsize_mm,mass\r\n1,2\r\n2,1\r\n3,0", case)
accept("quoted_fields", '"size_mm" , "mass"\n"1","2"\n 2 ,\t1\n"3","0"\n', case)
accept("semicolon_decimal_comma", "size_mm;mass\n0,5;2\n1;0,5\n1,5;0\n", Case(["0.5", "1", "1.5"], ["2", "0.5", "0"]))
accept("semicolon_decimal_point", "size_mm;mass\n0.5;2\n1;0.5\n1.5;0\n", Case(["0.5", "1", "1.5"], ["2", "0.5", "0"]))
accept("decimals_of_all_kinds", "size_mm,mass\n+1.e0,.2e+1\n2000E-3,1\n3,-0\n", case)
case = Case(["0", "1", "2", "4"], ["10", "30", "60", "0"])
accept("passing_implies_a_pan", "size_mm,passing_percent\n4,100\n2,40\n1,10\n", case)
accept("cumulative_implies_a_pan", "size_mm,cumulative_retained_percent\n4,0\n2,60\n1,90\n", case)
accept("passing_with_a_pan", "size_mm,passing_percent\nPan,0\n1,10\n2,40\n4,100\n", case)
accept("passing_fraction", "size_mm,passing_fraction\n1,0\n2,0.4\n4,1\n",
       Case(["1", "2", "4"], ["0.4", "0.6", "0"]))
accept("cumulative_from_nothing", "size_mm,cumulative_retained_percent\n1,100\n2,60\n4,0\n",
       Case(["1", "2", "4"], ["40", "60", "0"]))
accept("inches", "size_in,mass\n0.375,1\n0.5,2\n1,0\n", Case(["9.525", "12.7", "25.4"], ["1", "2", "0"]))
accept("phi", "size_phi,mass\n1,1\n0,2\n-1.0,3\n-2,0\n", Case(["0.5", "1", "2", "4"], ["1", "2", "3", "0"]))
def phi(name, phis, m, extra_columns=(), header="size_phi,mass", **question):
    """Openings that are no rational numbers: half-phi and finer."""
    x, d = half(*phis)
    accept("half_phi_" + name, rows(header, phis, m, *extra_columns), Case(x, m, degree=d, **question))


PHIS, PHI_M = "2.5 2 1.5 1 0.5 0 -0.5 -1".split(), "1 3 0 2 7 5 4 0".split()
TIED_PHIS, TIED_M = "-2 -1.5 -1 -0.5 0".split(), "0 1 0 0 1".split()
case = Case(*(lambda x: (x[0], TIED_M[::-1]))(half(*TIED_PHIS[::-1])), degree=2)
assert case.N == 10
accept("half_phi_that_ties", rows("size_phi,mass", TIED_PHIS, TIED_M), case)
phi("sphere", PHIS, PHI_M)
phi("quarters", "1 0.75 0.5 0.25 -0.5".split(), "3 0 2 5 0".split())
phi("tenths", "1.1 1 0.9 0.2 -0.5".split(), "3 1 2 5 0".split())
phi("law_2", PHIS, PHI_M, law=(2, 1))
phi("law_5_2", PHIS, PHI_M, law=(5, 2))
phi("pan", ["pan", *PHIS], ["2", *PHI_M])
phi("pan_size", ["pan", *PHIS], ["2", *PHI_M], pan="0.1")
phi("size_factor", PHIS, PHI_M, factor="2.5")
phi("cut_at_a_rational_opening", PHIS, PHI_M, cut="0.25")
phi("cut_at_15_digits", PHIS, PHI_M, cut="0.353553390593274")
phi("cut_at_3_of_15_digits", ["9.5", "8", "7"], ["1", "2", "0"], cut="0.00138106793200498")
phi("cut_leaves_whole_phi", ["1.5", "1", "0", "-1"], ["4", "1", "2", "0"], cut="0.5")
phi("min_per_class", PHIS, PHI_M, least=4)
phi("cylinder", PHIS, PHI_M, cylinder="6 7 0.6")
phi("bounds", ["0.5", "0.375", "0.25"], ["5", "1", "0"], steps=0)
phi("box", PHIS, PHI_M, box="8 7 6.5 0.6", places=18)
phi("solids_volume", PHIS, PHI_M, volume="300", places=18)
phi("at_least", ["0.5", "0.375", "0.25"], ["5", "1", "0"], at_least=50)
phi("at_least_power_3_2", ["0.5", "0.375", "0.25"], ["5", "1", "0"], law=(3, 2), at_least=40)
phi("factors", PHIS, PHI_M, extra_columns=(["2", "1", "1", "3", "0.5", "1", "1", "1"],), header="size_phi,mass,factor",
    c=["2", "1", "1", "3", "0.5", "1", "1", "1"])
phi("everything", ["pan", *PHIS], ["2", *PHI_M], pan="0.15", cut="0.15", factor="1.5", least=2, cylinder="6 7 0.5",
    at_least=1600)
phi("pan_factor_cylinder", ["pan", "1.5", "1", "0.5"], ["2", "1", "3", "0"], pan="0.25", factor="1.5", cylinder="1 2 0.7")
phi("pan_cut_volume", ["pan", "1.5", "1", "0.5", "0"], ["2", "1", "3", "1", "0"], pan="0.15", cut="0.353553390593274",
    volume="0.5")
accept("sieve_names", "sieve,mass\npan,1\nNo. 200,2\n# a comment, no row\n\"#100\",3\n\" # 50 \",4\nno 30,5\n1.18 MM,6\n"
       "2360 \u00b5m,1\n4750\u03bcm,1\n3/8\",1\n 0.530 in.,1\n5/8 Inch,2\n1 1/2 inches,1\n0.05 m,0\n",
       Case("0 0.075 0.15 0.3 0.6 1.18 2.36 4.75 9.5 13.2 16 37.5 50".split(), "1 2 3 4 5 6 1 1 1 1 2 1 0".split()))
accept("comments_with_numbers", "# 4 sands of 2024\nsize_mm,mass\n1,2\n # 12 g were lost\n#no. 4,1\n#\n#-4\n2,1\n3,0\n",
       Case(TRIPLE_X, TRIPLE_M))
accept("sieve_names_tyler", 'sieve;mass\n"tyler 200 mesh";1\nTyler 100;2\n"1,18 mm";3\n"3/8""";0\n',
       Case(["0.075", "0.15", "1.18", "9.5"], ["1", "2", "3", "0"]))
accept("json_id_of_another_format", '{"id": "ITEM:", "sizes": [1, 2, 3], "masses": [2, 1, 0]}', Case(TRIPLE_X, TRIPLE_M))
accept("json", '{"id": 7, "sizes": ["1", 2, 3.0e0], "masses": [2, "1", "0"]}',
       Case(TRIPLE_X, TRIPLE_M))
accept("json_descending_inches",
       ' {"unit": "in", "masses": [0, 1, 2], "sizes": [3, 2, 1], "factors": ["1", "3", "2"],\n'
       '"tolerances_percent": [0, 0, 1], "\\u0069d": "a\\ud83d\\ude00\\n"}\n',
       Case(["25.4", "50.8", "76.2"], ["2", "1", "0"], c=["2", "3", "1"]))


def tree(name, N, x, m, *tolerance, header="size_mm,mass", columns=(), **question):
    """A match within a tolerance; N was found by hand, by the reason that stands beside it, or is what came out."""
    case = Tree(x, m, tolerance, **question)
    assert N == case.N, (name, case.N)
    accept("tree_" + name, rows(header, x, m, *columns), case)


LINEAR = {"law": (1, 1)}
OPEN_X, OPEN_M = ["0", "2", "5", "9"], ["2", "1", "1", "0"]
# Two particles would need one of size 2 in (2, 5]; an empty class 3 must be allowed.
tree("strict_where_a_class_is_occupied", 3, OPEN_X, OPEN_M, "retained 25", **LINEAR)
# One particle a class would need one of size 1 in (1, 2].
tree("relaxation_at_an_open_bound", 3, ["1", "2", "3"], ["2", "8", "0"], "total 10", **LINEAR)
# Particles of classes that touch: 2 and more than 2.
tree("open_bound_between_two_classes", 3, ["1", "2", "4"], ["1", "1", "0"], "retained 0", **LINEAR)
tree("closed_bound_between_two_classes", 2, ["1", "2", "4"], ["1", "2", "0"], "retained 0", **LINEAR)
tree("spheres_retained", 3, OPEN_X, OPEN_M, "retained 25")
tree("spheres_total", 2, ["1", "2", "3"], ["2", "8", "0"], "total 10")
tree("one_class", 1, ["1", "2"], ["5", "0"], "passing 0")
tree("any_sample", 1, OPEN_X, OPEN_M, "total 100", "band 20 100 100")
tree("total_above_100", 1, OPEN_X, OPEN_M, "total 150.5")
tree("no_tolerance_is_exact", 4, TRIPLE_X, TRIPLE_M, "retained 0")
tree("class_without_mass_holds_a_particle", 2, ["1", "2", "3", "4"], ["1", "0", "2", "0"], "retained 40", "passing 20",
     **LINEAR)
tree("passing", 6, OPEN_X, OPEN_M, "passing 5", **LINEAR)
tree("passing_each", 6, OPEN_X, OPEN_M, "passing-each 1.25 16", **LINEAR)
tree("passing_each_and_more", 6, OPEN_X, OPEN_M, "retained 12", "passing 15", "passing-each 10 4", "total 20.5",
     **LINEAR)
tree("band", 3, ["1", "2", "3"], ["1", "1", "0"], "band 1 0 0", "band 2 20.5 21", **LINEAR)
tree("band_on_all_sieves", 3, ["1", "2", "3"], ["1", "1", "0"], "band 0.5 0 100", "band 2 10 24", "band 3 100 100",
     "band 4 50 100", **LINEAR)
TOLERANCES = ["30", "4", "10", "0"]
FILE = {"header": "size_mm,mass,tolerance_percent", "columns": (TOLERANCES,), "file": TOLERANCES}
tree("retained_file", 5, OPEN_X, OPEN_M, "retained file", **FILE, **LINEAR)
tree("passing_file", 6, OPEN_X, OPEN_M, "retained 20", "passing file", "total 25", **FILE, **LINEAR)
tree("min_per_class", 7, OPEN_X, OPEN_M, "retained 25", least="2", **LINEAR)
tree("min_per_class_1", 4, OPEN_X, OPEN_M, "retained 25", least="1", **LINEAR)
tree("at_least", 5, OPEN_X, OPEN_M, "retained 25", at_least="5", **LINEAR)
tree("cylinder", 3, ["0", "2", "3"], ["1", "1", "0"], "retained 40", cylinder="4 3.5 0.5")
tree("solids_volume", 3, ["0", "2", "3"], ["1", "1", "0"], "retained 40", volume="30")
tree("factors", 3, ["0", "2", "3"], ["1", "1", "0"], "passing 10", c=["2", "0.5", "1"], volume="20",
     header="size_mm,mass,factor", columns=(["2", "0.5", "1"],))
tree("law_3_2", 2, ["1", "4", "9"], ["1", "2", "0"], "retained 12.5", law=(3, 2))
tree("pan_cut_factor", 3, ["0", "1", "2", "4"], ["1", "2", "3", "0"], "total 20", "band 0.5 0 50", "band 2 0 60",
     "band 7 0 100", pan="0.5", cut="0.5", factor="2.5")
tree("passing_each_cut_factor", 3, ["0", "1", "2", "4", "8"], ["1", "2", "3", "2", "0"], "passing-each 20 15.5", pan="0.5", cut="1",
     factor="2.5", **LINEAR)
tree("none_of_a_band", None, OPEN_X, OPEN_M, "band 2 50 60", "band 5 20 40", **LINEAR)
tree("none_of_retained_and_passing", None, OPEN_X, OPEN_M, "retained 1", "band 5 0 70")
tree("none_of_an_empty_class", None, ["1", "2", "4"], ["1", "1", "0"], "band 2 0 0", least="2", **LINEAR)

# Version 2. More than one particle in classes 2 and 3 together: their masses are above the lower bounds, which no
# bound on a single class says.
WIDE_X, WIDE_M = ["0", "2", "4", "8"], ["1", "1", "1", "0"]
tree("sum_is_strict_where_occupied", 5, WIDE_X, WIDE_M, "band 2 75 85", sums=[(2, 3, 1)], avoid="f", **LINEAR)
tree("sums_and_single_classes", 6, OPEN_X, OPEN_M, "passing 5", sums=[(2, 3, 1), (1, 2, 5)], **LINEAR)
tree("sum_split_twice", 6, OPEN_X, OPEN_M, "passing 5", sums=[(2, 3, 3), (2, 3, 1)], **LINEAR)
tree("sums_of_an_empty_class", 2, ["1", "2", "3", "4"], ["1", "0", "2", "0"], "retained 40", "passing 20", sums=[(1, 2, 1)],
     avoid="f", **LINEAR)
tree("sums_at_least", 4, OPEN_X, OPEN_M, "retained 20", at_least="3", sums=[(2, 3, 1)], avoid="f", **LINEAR)
tree("sums_factors", 3, ["0", "2", "3"], ["1", "1", "0"], "passing 10", c=["2", "0.5", "1"], volume="20",
     header="size_mm,mass,factor", columns=(["2", "0.5", "1"],), sums=[(1, 2, 2)], avoid="f")
tree("sums_of_masses_that_fall", 3, ["0", "2", "3", "4"], ["3", "1", "1", "0"], "passing 2",
     c=["3", "1", "0.5", "1"], header="size_mm,mass,factor", columns=(["3", "1", "0.5", "1"],), sums=[(2, 3, 3), (1, 3, 4)],
     avoid="f", **LINEAR)
tree("bounds", 6, OPEN_X, OPEN_M, "passing 5", sums=[(2, 3, 1)], avoid="fn", below=4, **LINEAR)
tree("bounds_one_apart", 6, OPEN_X, OPEN_M, "passing 5", below=5, **LINEAR)
tree("bounds_of_nothing", 6, OPEN_X, OPEN_M, "passing 5", below=1, **LINEAR)
tree("bounds_at_least", 6, OPEN_X, OPEN_M, "passing 5", at_least="3", below=5, **LINEAR)
tree("bound_alone", None, OPEN_X, OPEN_M, "passing 5", sums=[(1, 3, 3)], avoid="n", below=4, with_witness=False, **LINEAR)
tree("bound_alone_of_all", None, OPEN_X, OPEN_M, "passing 5", below=6, with_witness=False, **LINEAR)
tree("bound_alone_at_least", None, OPEN_X, OPEN_M, "passing 5", at_least="3", below=6, with_witness=False, **LINEAR)


def windows(name, N, x, m, *tolerance, header="size_mm,mass", columns=(), **question):
    """Version 3: the same with splits of the mass at `masses`."""
    case = WindowTree(x, m, tolerance, **question)
    assert N == case.N, (name, case.N)
    accept("tree_windows_" + name, rows(header, x, m, *columns), case)


windows("retained", 3, OPEN_X, OPEN_M, "retained 25", masses=["4", "8"], **LINEAR)
windows("tied", 3, ["1", "2", "3"], ["2", "8", "0"], "total 10", masses=["4", "5"], **LINEAR)
windows("between_two_classes", 3, ["1", "2", "4"], ["1", "1", "0"], "retained 0", masses=["4"], **LINEAR)
windows("passing", 6, OPEN_X, OPEN_M, "passing 5", masses=["10", "15", "20"], **LINEAR)
windows("passing_each_and_more", 6, OPEN_X, OPEN_M, "retained 12", "passing 15", "passing-each 10 4", "total 20.5",
        masses=["31/2", "18", "61/3"], **LINEAR)
windows("total", 5, OPEN_X, OPEN_M, "total 20", masses=["12", "15", "18"], **LINEAR)
windows("total_100", 3, OPEN_X, OPEN_M, "total 100", masses=["9"], at_least="3", **LINEAR)
windows("band", 3, ["1", "2", "3"], ["1", "1", "0"], "band 1 0 0", "band 2 20.5 21", masses=["5", "6"], **LINEAR)
windows("class_without_mass", 2, ["1", "2", "3", "4"], ["1", "0", "2", "0"], "retained 40", "passing 20", masses=["4"],
        **LINEAR)
windows("min_per_class", 7, OPEN_X, OPEN_M, "retained 25", least="2", masses=["14", "18"], **LINEAR)
windows("at_least", 5, OPEN_X, OPEN_M, "retained 25", at_least="5", masses=["8"], **LINEAR)
windows("spheres", 3, OPEN_X, OPEN_M, "retained 25", masses=["100", "500"])
windows("cylinder", 3, ["0", "2", "3"], ["1", "1", "0"], "retained 40", cylinder="4 3.5 0.5", masses=["30", "59.5"])
windows("solids_volume", 3, ["0", "2", "3"], ["1", "1", "0"], "retained 40", volume="30", masses=["57", "59"])
windows("factors", 3, ["0", "2", "3"], ["1", "1", "0"], "passing 10", c=["2", "0.5", "1"], volume="20",
        header="size_mm,mass,factor", columns=(["2", "0.5", "1"],), masses=["20", "40"])
windows("law_3_2", 2, ["1", "4", "9"], ["1", "2", "0"], "retained 12.5", law=(3, 2), masses=["24"])
windows("sums", 6, OPEN_X, OPEN_M, "passing 5", sums=[(2, 3, 2), (1, 3, 5)], **LINEAR)
windows("bounds", 6, OPEN_X, OPEN_M, "passing 5", masses=["12", "20"], below=5, **LINEAR)
windows("bound_alone", None, OPEN_X, OPEN_M, "passing 5", masses=["12", "20"], below=4, with_witness=False, **LINEAR)
windows("beside_leaves", 6, OPEN_X, OPEN_M, "passing 5", masses=["12"], plain=True, **LINEAR)
windows("none", None, OPEN_X, OPEN_M, "band 2 50 60", "band 5 20 40", masses=["10"], **LINEAR)
x, d = half("1.5", "1", "0.5")
case = WindowTree(x, ["3", "1", "0"], ["retained 5"], law=(2, 1), degree=d, masses=["1"])
accept("tree_windows_half_phi", rows("size_phi,mass", ["1.5", "1", "0.5"], ["3", "1", "0"]), case)

x, d = half("1.5", "1", "0.5")
case = Tree(x, ["3", "1", "0"], ["retained 5"], law=(2, 1), degree=d, sums=[(1, 2, 3)], below=3, avoid="f")
accept("tree_sums_half_phi", rows("size_phi,mass", ["1.5", "1", "0.5"], ["3", "1", "0"]), case)
for name, N, options, *tolerance in (("retained", 4, {}, "retained 5"), ("total", 5, {"at_least": "5"}, "total 20"),
                                     ("passing_each", 4, {}, "passing-each 5"),
                                     ("band", None, {"most": 4}, "passing 5", "band 0.25 0 0", "band 0.5 41 45")):
    case = Tree(x, ["3", "1", "0"], tolerance, law=(2, 1), degree=d, **options)
    assert N == case.N, (name, case.N)
    accept("tree_half_phi_" + name, rows("size_phi,mass", ["1.5", "1", "0.5"], ["3", "1", "0"]), case)


def band(name, N, limits, x, m, *tolerance, header="size_mm,passing_min_percent,passing_max_percent", unit=F(1), written=None,
         **question):
    """A band's file alone; x and m are its middle by hand."""
    lines = [f"band {decimal(F(X) * unit)} {low} {high}" for X, low, high in sorted(limits, key=lambda row: F(row[0]))]
    case = Tree(x, m, [*tolerance, *lines], band_file=True, **question)
    print(name, case.N)
    sizes = written or [row[0] for row in limits]
    accept("band_" + name, header + "\n" + "".join(f"{size},{low},{high}\n" for size, (_, low, high) in zip(sizes, limits)),
           case)


LIMITS = [("1", "0", "0"), ("2", "20.5", "21"), ("3", "90", "100")]
band("alone", 3, LIMITS, ["1", "2", "3"], ["20.75", "79.25", "0"], **LINEAR)
band("alone_in_inches", 2, [("2", "20", "30"), ("1", "0", "0"), ("3", "100", "100")], ["25.4", "50.8", "76.2"],
     ["25", "75", "0"], unit=F("25.4"), header="size_in,passing_min_percent,passing_max_percent", **LINEAR)
band("with_an_implied_pan", 3, [("2", "10", "20"), ("5", "50", "60"), ("9", "90", "100")], ["0", "2", "5", "9"],
     ["15", "40", "45", "0"], **LINEAR)
band("of_one_sieve", 1, [("2", "0", "100")], ["0", "2"], ["100", "0"], **LINEAR)
band("and_its_middle", 3, [("0", "0", "50"), ("2", "10", "20"), ("5", "5", "60"), ("9", "90", "100")],
     ["0", "2", "5", "9"], ["15", "20", "65", "0"], "retained 10", **LINEAR)
band("that_contradicts_itself", None, [("1", "0", "0"), ("2", "50", "60"), ("5", "20", "40"), ("9", "0", "100")],
     ["1", "2", "5", "9"], ["50", "0", "50", "0"], most=4, **LINEAR)
band("in_phi", 2, [("1", "0", "0"), ("2", "20", "30"), ("4", "100", "100")], ["1", "2", "4"], ["25", "75", "0"],
     written=["0", "-1", "-2"], header="size_phi,passing_min_percent,passing_max_percent", **LINEAR)


def edit(name, base, *changes, into=rejected, gradation=None):
    """A certificate with lines replaced: pairs of the beginning of a line and the new line (None drops it)."""
    csv, proof = accepted[base]
    lines = proof.splitlines()
    for beginning, line in changes:
        hits = [i for i, old in enumerate(lines) if (old + " ").startswith(beginning)]
        assert len(hits) == 1, (name, beginning)
        lines[hits[0]:hits[0] + 1] = [] if line is None else line.split("\n")
    into[name] = (gradation if gradation is not None else csv, "\n".join(lines) + "\n")


def claim(name, gradation, case, **changes):
    """A certificate of which single values are wrong."""
    for key, value in changes.items():
        setattr(case, key, value)
    rejected[name] = (gradation, case.proof())


def triple(**question):
    return Case(TRIPLE_X, TRIPLE_M, **question)


TRIPLE = rows("size_mm,mass", TRIPLE_X, TRIPLE_M)
ATHABASCA = rows("size_mm,mass", ATHABASCA_X, ATHABASCA_M)
NARROW = rows("size_mm,mass", NARROW_X, NARROW_M)

# The witness.
claim("one_more_than_least_with_a_valid_witness", TRIPLE, triple(extra=1))
edit("sum_is_not_the_claim", "sphere_two_classes", ("particles", "particles 5"))
edit("claim_below_the_sum", "sphere_two_classes", ("particles", "particles 3"))
case = Case(NARROW_X, NARROW_M)
claim("scale_at_the_open_end", NARROW, case, S=case.L)
case = Case(NARROW_X, NARROW_M, scale="upper")
claim("scale_above_the_closed_end", NARROW, case, S=case.U + F(1, 10**30))
edit("class_is_missing", "interior_zeros", ("class 3", None))
edit("class_without_mass", "interior_zeros", ("class 3", "class 2 1 2.5 2.5"))
edit("class_without_mass_too", "interior_zeros", ("class 5", "class 4 1 4.5 4.5\n" + "class 5 1 5.5 5.5"))
edit("class_beyond_the_last", "sphere_two_classes", ("chain", "CHAIN"), ("CHAIN", "class 3 1 3.5 3.5\nchain 2"))
edit("class_zero", "sphere_two_classes", ("class 1", "class 0 3 1 1"))
edit("fewer_than_min_per_class", "sphere_two_classes", ("law", "law 3\nmin-per-class 2"))
case = Case(NARROW_X, NARROW_M)
claim("exchanged_quantities", NARROW, case, q={0: case.q[1], 1: case.q[0], 2: case.q[2]})
case = triple()
claim("another_law", TRIPLE, case, law=(2, 1))
case = Case(ATHABASCA_X, ATHABASCA_M, law=(5, 2))
claim("law_5_2_claimed_as_5", ATHABASCA, case, law=(5, 1))
edit("another_gradation", "sphere_two_classes", gradation="size_mm,mass\n1,2\n2,1.5\n3,0\n")
edit("another_unit", "sphere_two_classes", gradation="size_in,mass\n1,2\n2,1\n3,0\n")

# The sizes.
EXACT = rows("size_mm,mass", ["1", "2", "4"], ["1", "8", "0"])


def sizes(name, base_case, gradation, j, lo, hi):
    claim(name, gradation, base_case, sizes={**base_case.sizes, j: (lo, hi)})


def moved(case, j, units):
    unit = F(case.sizes[j][1]) - F(case.sizes[j][0])
    return [decimal(F(end) + units * unit) for end in case.sizes[j]]


for direction, units in (("low", -1), ("high", 1)):
    case = triple()
    sizes(f"enclosure_one_unit_too_{direction}", case, TRIPLE, 0, *moved(case, 0, units))
case = Case(["1", "2", "4"], ["1", "8", "0"], scale="upper")
sizes("exact_size_as_an_upper_end", case, EXACT, 1, "3.999999999999", "4")
case = Case(["1", "2", "4"], ["1", "8", "0"], scale="upper")
sizes("enclosure_beyond_the_class", case, EXACT, 1, "4", "4.000000000001")
case = Case(["1", "2", "4"], ["1", "8", "0"], scale="upper")
sizes("exact_size_off", case, EXACT, 1, "3.999999999999", "3.999999999999")
case = triple()
sizes("enclosure_too_wide", case, TRIPLE, 0, *(decimal(F(root(int(F(case.S) * 2 * 10**24 / case.q[0]), 3) // 10**4 + i,
                                                         10**4)) for i in (0, 1)))
case = triple()
sizes("rounded_size_as_exact", case, TRIPLE, 0, *[case.sizes[0][0]] * 2)
# The size is above the opening, which the class excludes, by less than a unit: its enclosure begins at the opening.
case = Case(["1", "2"], ["1", "0"])
case.S = 1 + F(1, 10**12)
sizes("lower_end_at_the_opening", case, rows("size_mm,mass", ["1", "2"], ["1", "0"]), 0, "1", "1.000000000001")

# The chain.
case = Case(NARROW_X, NARROW_M)
claim("chain_one_step_short", NARROW, case, chain=case.chain[:-1])
claim("chain_without_steps", TRIPLE, triple(), chain=[])
edit("chain_index_zero", "sphere_two_classes", ("chain", "chain 0 2"))
edit("chain_index_beyond", "sphere_two_classes", ("chain", "chain 3 2"))
edit("chain_index_far_beyond", "sphere_two_classes", ("chain", "chain 2 999999999999999999"))
edit("chain_index_2_to_the_32_and_2", "sphere_two_classes", ("chain", "chain 4294967298"))
edit("chain_index_of_an_empty_class", "interior_zeros", ("chain", "chain 2 5 3 1 5 3 1 5 3 1"))
# The chain is closed without the floors that the question adds to the other class, and not with them.
for name, question in (("min_per_class", {"least": 50}), ("cylinder", {"cylinder": "6 5 0.5"}),
                       ("volume", {"volume": "100"})):
    x, m = ["1", "1.5", "2"], ["7", "4", "0"]
    case = Case(x, m, **question)
    claim(f"chain_without_the_floors_of_{name}", rows("size_mm,mass", x, m), case, chain=[0])
case = Case(NARROW_X, NARROW_M)
claim("chain_of_another_gradation", NARROW, case, chain=[0])

# The volume of the solids.
case = Case(ATHABASCA_X, ATHABASCA_M, cylinder="5 2.4 0.683", places=18)
rejected["cylinder_of_a_larger_void_ratio"] = (ATHABASCA, case.proof().replace("0.683", "0.6"))
case = Case(["1", "2"], ["1", "0"], cylinder="7 3 0.5", scale="start")
claim("cylinder_not_quite_full", rows("size_mm,mass", ["1", "2"], ["1", "0"]), case, S=case.S - F(1, 10**9))
edit("pi_low_too_high_in_the_last_digit", "box",
     ("pi", "pi 3.14159265358979323847 3.14159265358979323848"))
edit("pi_high_too_low_in_the_last_digit", "box",
     ("pi", "pi 3.14159265358979323845 3.14159265358979323846"))
edit("pi_coarse_bounds_lose_the_least", "solids_volume", ("pi", "pi 3 4"))

# At least M.
edit("fewer_than_at_least", "sphere_two_classes", ("particles", "at-least 5\nparticles 4"))
GAP_M = ["5", "1", "0", "0"]
GAP = rows("size_mm,mass", NARROW_X, GAP_M)
case = Case(NARROW_X, GAP_M, at_least=27)
higher = next(case.breakpoint(M) for M in range(27, 99) if case.breakpoint(M) > case.z)
claim("above_one_breakpoint_too_high", GAP, case, z=higher)
case = Case(NARROW_X, GAP_M, at_least=27)
claim("above_a_little_too_high", GAP, case, z=case.z + F(1, 10**20))
case = Case(NARROW_X, GAP_M, at_least=27)
claim("above_too_low_for_the_chain", GAP, case, z=case.z / 2, chain=case.chain[:-1])
edit("at_least_skipped_without_above", "at_least_skips_a_gap", ("above", None))
x, m = ["0", "1", "2"], ["100", "1", "0"]
claim("above_with_a_pan", rows("size_mm,mass", x, m), Case(x, m, at_least=2), z=F(1, 10**6))
claim("at_least_and_more_than_needed", GAP, Case(NARROW_X, GAP_M, at_least=30), M=29)

# Bounds.
case = Case(NARROW_X, NARROW_M, steps=5)
edit("bound_one_higher", "bounds_of_some_steps", ("particles", f"particles {case.bound + 1}..{case.N}"))
edit("bound_one_lower", "bounds_of_some_steps", ("particles", f"particles {case.bound - 1}..{case.N}"))
claim("bound_of_one_step_less", NARROW, case, chain=case.chain[:-1])
claim("bound_above_the_smallest", TRIPLE, triple(steps=1, extra=2), bound=5)
edit("bounds_with_another_number", "bounds_of_a_whole_chain", ("particles", "particles 4..6"))
edit("bounds_of_more_than_the_least", "bounds_of_no_step", ("law", "law 3\nmin-per-class 2"))
case = Case(NARROW_X, GAP_M, at_least=27, steps=0)
claim("bound_above_one_breakpoint_too_high", GAP, case,
      z=next(case.breakpoint(M) for M in range(27, 99) if case.breakpoint(M) > case.z))
case = Case(NARROW_X, NARROW_M, cylinder="0.5 0.4 0.5", steps=9)
rejected["bound_of_a_larger_cylinder"] = (NARROW, case.proof().replace("cylinder 0.5", "cylinder 50"))

# Questions that do not fit.
edit("pan_size_without_a_pan", "sphere_two_classes", ("law", "law 3\npan-size 0.5"))
edit("pan_size_as_large_as_the_next", "pan_size", ("pan-size", "pan-size 0.075"))
edit("pan_size_left_out", "pan_size_that_binds", ("pan-size", None))
edit("cut_between_openings", "cut_below", ("cut-below", "cut-below 0.31"))
edit("cut_at_the_largest", "sphere_two_classes", ("law", "law 3\ncut-below 3"))
edit("cut_leaves_no_mass", "sphere_two_classes", ("law", "law 3\ncut-below 2"), gradation="size_mm,mass\n1,2\n2,0\n3,0\n")
edit("cut_left_out", "cut_below", ("cut-below", None))
edit("size_factor_left_out", "size_factor", ("size-factor", None))

# Half-phi. Rounded openings claim 9 where 10 is the least.
rejected["half_phi_rounded"] = (accepted["half_phi_that_ties"][0],
                                Case(["1", "1.4142135623731", "2", "2.8284271247462", "4"], TIED_M[::-1]).proof())
rejected["half_phi_cut_one_unit_off"] = (accepted["half_phi_cut_at_15_digits"][0],
                                         accepted["half_phi_cut_at_15_digits"][1].replace("593274", "593275"))
rejected["half_phi_cut_at_14_digits"] = (accepted["half_phi_cut_at_15_digits"][0],
                                         accepted["half_phi_cut_at_15_digits"][1].replace("593274", "59327"))
rejected["half_phi_cut_at_16_digits"] = (accepted["half_phi_cut_at_15_digits"][0],
                                         accepted["half_phi_cut_at_15_digits"][1].replace("593274", "5932738"))
edit("half_phi_scale_is_no_power", "half_phi_sphere", ("scale", "scale 7/2"))
edit("half_phi_of_another_root", "half_phi_cut_leaves_whole_phi", gradation="size_phi,mass\n1,1\n0,2\n-1,0\n")
edit("half_phi_larger_cylinder", "half_phi_cylinder", ("cylinder", "cylinder 6.1 7 0.6"))
edit("tree_half_phi_irrational_masses", "tree_half_phi_retained", ("law", "law 3"))
edit("tree_half_phi_band_at_a_rounded_opening", "tree_half_phi_retained",
     ("retained", "retained 5\nband 0.353553390593274 0 0"))

# Bands alone.
edit("band_lines_beside_its_file", "band_alone", ("band file", "band 1 0 0\nband 2 20.5 21\nband 3 90 100"))
edit("band_file_beside_a_gradation", "tree_band", ("band 1", "band file"), ("band 2", None))
edit("band_of_an_exact_match", "sphere_two_classes", gradation=accepted["band_alone"][0])
edit("band_of_another_file", "band_alone", gradation=accepted["band_alone"][0].replace("20.5", "20.9"))

# Trees. A leaf or a line of the witness is exchanged for a wrong one.
def leaf_edit(name, base, old, new, into=rejected):
    """The text `old`, which is there exactly once, replaced."""
    csv, proof = accepted["tree_" + base]
    assert proof.count(old) == 1, (name, proof)
    into["tree_" + name] = (csv, proof.replace(old, new))


OPEN, AT_OPEN = "strict_where_a_class_is_occupied", "relaxation_at_an_open_bound"
HAND = """mdm-certificate 1
law 1
total 10
particles 3
class 1 1 3/2 1.5 1.5
class 2 2 5 2.5 2.5
split 2 1
leaf 4 e1 4 E 4 x2 4 F2 12 Q2 3 m
split 1 1
leaf 20 e2 20 E 20 x1 20 F1 40 Q1 3 m
leaf 4 e1 4 E 4 x2 3 f1 1 F2 3 N 6 q1
end
"""
BY_HAND = rows("size_mm,mass", ["1", "2", "3"], ["2", "8", "0"])
accepted["tree_by_hand"] = (BY_HAND, HAND)
for name, old, new in (
        ("one_more_than_least", "particles 3\n", "particles 4\n"),
        ("one_more_in_claim_and_witness", "particles 3\nclass 1 1 3/2", "particles 4\nclass 1 2 3"),
        ("one_less_than_least", "particles 3\n", "particles 2\n"),
        ("one_less_in_claim_and_witness", "particles 3\nclass 1 1 3/2 1.5 1.5\nclass 2 2 5 2.5 2.5",
         "particles 2\nclass 1 1 1 1 1\nclass 2 1 3 3 3"),
        ("claims_that_there_is_none", HAND[HAND.index("particles"):HAND.index("split 2")], "particles none\n"),
        ("without_the_split_that_makes_a_bound_strict",
         "split 1 1\nleaf 20 e2 20 E 20 x1 20 F1 40 Q1 3 m\nleaf 4 e1 4 E 4 x2 3 f1 1 F2 3 N 6 q1",
         "leaf 4 e1 4 E 4 x2 3 f1 1 F2 3 N 6 q1"),
        ("split_that_is_not_where_it_was", "split 1 1", "split 2 1"),
        ("split_at_two", "split 1 1", "split 1 2"),
        ("subtrees_exchanged", "leaf 20 e2 20 E 20 x1 20 F1 40 Q1 3 m\nleaf 4 e1 4 E 4 x2 3 f1 1 F2 3 N 6 q1",
         "leaf 4 e1 4 E 4 x2 3 f1 1 F2 3 N 6 q1\nleaf 20 e2 20 E 20 x1 20 F1 40 Q1 3 m"),
        ("split_of_class_zero", "split 1 1", "split 0 1"),
        ("split_of_a_class_beyond", "split 1 1", "split 3 1"),
        ("split_far_beyond", "split 1 1", "split 4294967297 1"),
        ("leaf_of_a_class_beyond", "4 x2 4 F2", "4 x3 4 F2"),
        ("leaf_far_beyond", "4 x2 4 F2", "4 x4294967298 4 F2"),
        ("multiplier_one_more", "12 Q2", "13 Q2"),
        ("multiplier_one_less", "6 q1", "5 q1"),
        ("without_the_strict_condition", "40 Q1 3 m", "40 Q1"),
        ("leaf_with_nothing_strict", "leaf 4 e1 4 E 4 x2 4 F2 12 Q2 3 m", "leaf 1 q2 1 Q2"),
        ("leaf_true", "leaf 4 e1 4 E 4 x2 4 F2 12 Q2 3 m", "leaf 1 m"),
        ("bound_of_the_other_branch", "3 N 6 q1", "3 N 6 Q1"),
        ("most_without_a_bound", "leaf 4 e1 4 E 4 x2 4 F2 12 Q2 3 m", "leaf 4 e1 4 E 4 x2 4 F2 12 Q1 3 m"),
        ("tighter_total", "total 10", "total 5"),
        ("looser_total", "total 10", "total 11"),
        ("another_tolerance", "total 10", "retained 10"),
        ("another_law", "law 1", "law 2"),
        ("irrational_law", "law 1", "law 1/2"),
        ("at_least_more", "total 10", "at-least 4\ntotal 10"),
        ("min_per_class", "total 10", "min-per-class 2\ntotal 10"),
        ("column_of_tolerances_missing", "total 10", "retained file\ntotal 10"),
        ("passing_each_too_many", "total 10", "passing-each 50 50\ntotal 10"),
        ("band_at_no_opening", "total 10", "total 10\nband 2.5 0 100"),
        ("band_below_the_finest", "total 10", "total 10\nband 0.5 1 100"),
        ("band_at_the_finest", "total 10", "total 10\nband 1 0.1 100"),
        ("band_that_the_witness_misses", "total 10", "total 10\nband 2 0 23"),
        ("band_above_the_largest", "total 10", "total 10\nband 7 0 99.9"),
        ("witness_of_a_class_beyond", "class 2 2 5 2.5 2.5", "class 3 2 5 2.5 2.5"),
        ("witness_of_class_zero", "class 1 1 3/2 1.5 1.5", "class 0 1 3/2 1.5 1.5"),
        ("witness_without_a_class", "class 1 1 3/2 1.5 1.5\n", ""),
        ("witness_with_another_mass", "class 1 1 3/2 1.5 1.5", "class 1 1 4/3 1.5 1.5"),
        ("witness_with_another_size", "class 1 1 3/2 1.5 1.5", "class 1 1 3/2 1.4 1.4"),
        ("witness_with_a_wide_size", "class 1 1 3/2 1.5 1.5", "class 1 1 3/2 1.5 1.50000001"),
        ("witness_at_the_open_bound", "class 1 1 3/2 1.5 1.5", "class 1 1 1 1 1"),
        ("witness_above_the_closed_bound", "class 2 2 5 2.5 2.5", "class 2 2 7 3.5 3.5"),
        ("witness_beyond_the_tolerance", "class 1 1 3/2 1.5 1.5", "class 1 1 2 2 2"),
        ("witness_exchanged", "class 1 1 3/2 1.5 1.5\nclass 2 2 5 2.5 2.5",
         "class 1 2 5 2.5 2.5\nclass 2 1 3/2 1.5 1.5")):
    assert HAND.count(old) == 1, name
    rejected["tree_" + name] = (BY_HAND, HAND.replace(old, new))
accepted["tree_version_2_without_need"] = (BY_HAND, HAND.replace("mdm-certificate 1", "mdm-certificate 2"))
leaf = accepted["tree_none_of_a_band"][1].splitlines()[-2]
edit("tree_sums_none", "tree_none_of_a_band", ("mdm-certificate", "mdm-certificate 2"),
     ("leaf", f"split 1-3 2\n{leaf}\n{leaf}"), into=accepted)
# Version 2 by hand: certificate-format.md, section 9.
WIDE = rows("size_mm,mass", WIDE_X, WIDE_M)
CLASSES = "class 1 4 8 2 2\nclass 2 1 8/3 2.666666666666 2.666666666667\n"
STRICT = f"""mdm-certificate 2
law 1
band 2 75 85
particles 5
{CLASSES}split 2-3 1
leaf 20 P1 3 m 20 F2 20 F3 160 S2-3 80 q2
leaf 16 p1 4 F1 12 d2-3 8 N 32 s2-3 24 q3
end
"""
CLOSED = STRICT.replace("12 d2-3", "12 f2 12 f3")
accepted["tree_sums_by_hand"] = (WIDE, STRICT)
accepted["tree_bounds_by_hand"] = (WIDE, CLOSED.replace("particles 5", "particles 4..5"))
accepted["tree_bound_alone_by_hand"] = (WIDE, CLOSED.replace("particles 5", "particles 4..").replace(CLASSES, ""))
rejected["tree_sums_by_hand_closed"] = (WIDE, CLOSED)
rejected["tree_bound_alone_by_hand_closed"] = (WIDE, CLOSED.replace("particles 5", "particles 5..").replace(CLASSES, ""))
# Version 3 by hand: certificate-format.md, section 9.
WINDOWS = """mdm-certificate 3
law 1
retained 25
particles 3
class 1 2 4 2 2
class 2 1 4 4 4
split M 8
split M 4
window 1 t
window 3 N 8 t
window 1 N 2 t
end
"""
OPEN_TABLE = rows("size_mm,mass", OPEN_X, OPEN_M)
accepted["tree_windows_by_hand"] = (OPEN_TABLE, WINDOWS)
accepted["tree_version_3_without_need"] = (BY_HAND, HAND.replace("mdm-certificate 1", "mdm-certificate 3"))
accepted["tree_windows_bounds_by_hand"] = (OPEN_TABLE, WINDOWS.replace("particles 3", "particles 2..3"))
# M <= 7 is refuted in two halves of which one has no mass at all.
accepted["tree_windows_that_contradict"] = (OPEN_TABLE, WINDOWS.replace("split M 4", "split M 9\nsplit M 4").replace(
    "window 3 N 8 t\n", "window 3 N 8 t\nwindow 3 N 8 t\n"))
# A window in which a class that must hold particles can hold none.
accepted["tree_windows_without_room"] = (rows("size_mm,mass", ["2", "5", "9"], ["1", "1", "0"]), """mdm-certificate 3
law 1
retained 0
particles 2..
split M 4
window
window 1 N
end
""")
# Volume 9 needs M > 8: the coarse class holds at most three quarters, and one of the fine one 2.
FULL = """mdm-certificate 3
law 3
cylinder 2 2.26 0.5
retained 25
particles 3..
split M 8
window 1 T 1 w
window 1 N
end
"""
FULL_TABLE = "size_mm,mass,factor\n0,1,2\n1,1,0.75\n2,0,1\n"
accepted["tree_windows_volume_by_hand"] = (FULL_TABLE, FULL)
# Exactly full at M = 8, where the share of class 1 is at its lower end, 1/4, which is its own: two particles are enough.
rejected["tree_windows_at_a_lower_end_of_a_share"] = (FULL_TABLE, FULL.replace("2.26", "2.25"))
# M <= 114 has too little volume. Above, two particles of class 2 and one of class 1 are a match: two are the last count
# before class 2 has its greatest share.
BEFORE_AN_END = """mdm-certificate 3
law 3
cylinder 2 14.25 0.5
band 2 4 90
particles 3..
split M 114
window 2 T 5 w
window 1 N 4 t
end
"""
BEFORE_TABLE = "size_mm,mass,factor\n0,1,3\n2,1,2\n3,0,1\n"
accepted["tree_windows_of_a_count_before_an_end"] = (BEFORE_TABLE, BEFORE_AN_END)
rejected["tree_windows_of_a_count_before_an_end"] = (BEFORE_TABLE, BEFORE_AN_END.replace("3..", "4.."))
# Class 2 adds most with three particles, which bring it to its share of the gradation; two do not, and 0, 1, 5 and 6, at the
# ends of its counts and where it comes to the greatest share, add less.
AT_ITS_SHARE = """mdm-certificate 3
law 3
cylinder 2 15 0.5
total 80
particles 3..
split M 59
window 1 T 1 w
window 29 E 1 N 29 t
end
"""
SHARE_TABLE = "size_mm,mass\n0,4\n1,4\n2,3\n4,0\n"
accepted["tree_windows_of_a_count_at_its_share"] = (SHARE_TABLE, AT_ITS_SHARE)
rejected["tree_windows_of_a_count_at_its_share"] = (SHARE_TABLE, AT_ITS_SHARE.replace("3..", "5.."))
# Ten particles match. In each class most particles fit beside the excess where the lightest ones have its share: three, or
# two; with one particle, and with as many as the window holds, the sum would be less than the right side.
rejected["tree_windows_of_a_count_of_the_lightest"] = ("size_mm,mass\n10,1\n11,1\n12,1\n13,1\n14,0\n", """mdm-certificate 3
law 1
at-least 10
total 40
particles 11..
split M 140
window 28 E 1 n
window 1 N 10 t
end
""")
# One particle of class 1 is enough; class 2 is empty.
EMPTY_CLASS = "size_mm,mass\n0,2\n2,1\n5,0\n"
QUESTION = "mdm-certificate 3\nlaw 1\n"
rejected["tree_windows_of_an_empty_class"] = (EMPTY_CLASS, QUESTION + "retained 40\nparticles 2..\nwindow 1 N 1 t\nend\n")
# Any number of particles fit without an upper end of the window.
rejected["tree_windows_without_greatest_counts"] = (
    EMPTY_CLASS, QUESTION + "at-least 5\nretained 40\nparticles 9..\nwindow 1 n\nend\n")
for name, old, new in (
        ("one_more_than_least", "particles 3\n", "particles 4\n"),
        ("bound_one_more", WINDOWS[WINDOWS.index("particles"):WINDOWS.index("split M 8")], "particles 4..\n"),
        ("claims_none", WINDOWS[WINDOWS.index("particles"):WINDOWS.index("split M 8")], "particles none\n"),
        ("split_too_low", "split M 4", "split M 3"),
        ("split_a_little_too_low", "split M 4", "split M 3999999999/1000000000"),
        ("split_too_high", "split M 4", "split M 5"),
        ("outer_split_too_low", "split M 8", "split M 2"),
        ("split_of_counts", "split M 8", "split 1 8"),
        ("subtrees_exchanged", "window 1 t\nwindow 3 N 8 t", "window 3 N 8 t\nwindow 1 t"),
        ("another_sign", "window 1 t\n", "window 1 T\n"),
        ("multiplier_less", "3 N 8 t", "2 N 8 t"),
        ("multiplier_more", "3 N 8 t", "5 N 8 t"),
        ("without_multiples", "window 3 N 8 t", "window"),
        ("without_the_number", "window 1 N 2 t", "window 2 t"),
        ("of_a_class_beyond", "window 1 t", "window 1 t 1 P4"),
        ("of_a_class_far_beyond", "window 1 t", "window 1 t 1 P4294967297"),
        ("of_classes_beyond", "window 1 t", "window 1 t 1 s2-4"),
        ("with_a_sum_without_bound", "window 1 t", "window 1 t 1 S1-2"),
        ("tighter", "retained 25", "retained 24"),
        ("looser", "retained 25", "retained 26"),
        ("of_passing", "retained 25", "passing 25"),
        ("of_another_law", "law 1", "law 2"),
        ("with_at_least", "retained 25", "at-least 4\nretained 25"),
        ("with_min_per_class", "retained 25", "min-per-class 2\nretained 25"),
        ("of_a_leaf_instead", "window 3 N 8 t", "leaf 3 N 8 m")):
    assert WINDOWS.count(old) == 1, name
    rejected["tree_windows_" + name] = (OPEN_TABLE, WINDOWS.replace(old, new))
SUM, SUM_BOUND = "tree_sum_is_strict_where_occupied", "tree_bounds"
STRICT_LEAF = "leaf 4 F1 3 F3 8 N 3 P2 12 d2-3 16 p1 32 s2-3"
edit("tree_sum_one_more_than_least", SUM, ("particles", "particles 6"))
edit("tree_sum_one_more_as_a_bound", SUM, ("particles", "particles 6.."), ("class 1", None), ("class 2", None))
edit("tree_sum_without_a_strict_bound", SUM, (STRICT_LEAF, STRICT_LEAF.replace("12 d2-3", "12 f2 12 f3 24 q3")))
edit("tree_sum_strict_by_another_sum", SUM, ("split 2-3 1", "split 1-3 1"))
edit("tree_sum_split_at_2", SUM, ("split 2-3 1", "split 2-3 2"))
edit("tree_sum_of_one_class_more", SUM, (STRICT_LEAF, STRICT_LEAF.replace("12 d2-3", "12 d1-3")))
edit("tree_sum_without_an_upper_bound", SUM, (STRICT_LEAF, STRICT_LEAF + " 1 S2-3"))
edit("tree_sum_with_the_bound_of_another", SUM, ("leaf 40", "leaf 40 F2 20 F3 20 P1 160 S1-3 3 m 20 r2"))
edit("tree_sum_beyond_the_last_class", SUM, ("split 2-3 1", "split 2-4 1"))
edit("tree_sum_from_class_0", SUM, ("split 2-3 1", "split 0-3 1"))
edit("tree_condition_beyond_the_last_class", SUM, (STRICT_LEAF, STRICT_LEAF.replace("s2-3", "s2-4")))
edit("tree_sum_far_beyond_the_last_class", SUM, (STRICT_LEAF, STRICT_LEAF + " 1 s1-999999999999999999"))
edit("tree_bound_one_higher", "tree_bounds_by_hand", ("particles", "particles 5..6"), ("class 1", "class 1 5 10 2 2"))
edit("tree_bound_of_all_one_higher", "tree_bound_alone_of_all", ("particles", "particles 7.."))
edit("tree_bound_above_the_match", SUM_BOUND, ("particles", "particles 6..7"))
edit("tree_bounds_with_another_number", SUM_BOUND, ("particles", "particles 4..5"))
edit("tree_bounds_that_claim_the_smallest", SUM_BOUND, ("particles", "particles 6"))
edit("tree_bounds_without_a_witness", SUM_BOUND, *((f"class {j}", None) for j in (1, 2, 3)))
edit("tree_bound_that_claims_none", "tree_bound_alone", ("particles", "particles none"))
edit("tree_file_with_other_tolerances", "tree_retained_file",
     gradation=rows("size_mm,mass,tolerance_percent", OPEN_X, OPEN_M, ["30", "9", "10", "0"]))
edit("tree_file_with_other_tolerances_of_sieves", "tree_passing_file",
     gradation=rows("size_mm,mass,tolerance_percent", OPEN_X, OPEN_M, ["30", "9", "20", "0"]))
edit("tree_of_another_gradation", "tree_" + OPEN, gradation=rows("size_mm,mass", OPEN_X, ["1", "2", "1", "0"]))
edit("tree_of_a_larger_cylinder", "tree_cylinder", ("cylinder", "cylinder 5 4 0.5"))
edit("tree_of_a_smaller_volume", "tree_solids_volume", ("solids-volume", "solids-volume 20"))
edit("tree_of_a_larger_volume", "tree_solids_volume", ("solids-volume", "solids-volume 40"))
edit("tree_pi_low_too_high", "tree_solids_volume", ("pi", "pi 3.14159265358979323847 3.14159265358979323848"))
edit("tree_none_by_the_bound_on_N", "tree_none_of_a_band", ("leaf", "leaf 1 n 1 N"))
edit("tree_min_per_class_left_out", "tree_min_per_class", ("min-per-class", None))
edit("tree_at_least_left_out", "tree_at_least", ("at-least", None))
edit("tree_size_factor_left_out", "tree_pan_cut_factor", ("size-factor", None))


def garble(name, *changes, base="sphere_two_classes"):
    edit(name, base, *changes, into=unparsable)


garble("unknown_version", ("mdm-certificate", "mdm-certificate 4"))
garble("version_3_of_an_exact_match", ("mdm-certificate", "mdm-certificate 3"))
garble("version_3_of_bounds_of_an_exact_match", ("mdm-certificate", "mdm-certificate 3"), base="bounds_of_some_steps")
garble("version_2_of_an_exact_match", ("mdm-certificate", "mdm-certificate 2"))
garble("version_1_with_bounds", ("mdm-certificate", "mdm-certificate 1"), base="bounds_of_some_steps")
garble("bounds_that_are_the_same", ("particles", "particles 5..5"), base="bounds_of_a_whole_chain")
garble("bounds_that_descend", ("particles", "particles 5..4"), base="bounds_of_a_whole_chain")
garble("bounds_from_0", ("particles", "particles 0..5"), base="bounds_of_a_whole_chain")
garble("bound_alone_of_an_exact_match", ("particles", "particles 4.."), base="bounds_of_a_whole_chain")
garble("bounds_without_a_chain", ("chain", None), base="bounds_of_a_whole_chain")
garble("bounds_at_least_with_a_chain", ("end", "chain\nend"), base="bounds_at_least_without_a_chain")
garble("unknown_line", ("law", "law 3\ncomment 3"))
garble("options_out_of_order", ("law", "law 3\nmin-per-class 2\nsize-factor 2"))
garble("option_twice", ("law", "law 3\nsize-factor 2\nsize-factor 2"))
garble("law_missing", ("law", None))
garble("law_zero", ("law", "law 0"))
garble("law_not_in_lowest_terms", ("law", "law 6/2"))
garble("law_with_denominator_one", ("law", "law 3/1"))
garble("law_too_large", ("law", "law 1001"))
garble("pan_size_zero", ("law", "law 3\npan-size 0"))
garble("size_factor_one", ("law", "law 3\nsize-factor 1"))
garble("min_per_class_one", ("law", "law 3\nmin-per-class 1"))
garble("at_least_one", ("particles", "at-least 1\nparticles 4"))
garble("cylinder_with_another_law", ("law", "law 2\ncylinder 1 1 0"))
garble("cylinder_and_box", ("law", "law 3\ncylinder 1 1 0\nbox 1 1 1 0\npi 3 4"))
garble("box_without_pi", ("law", "law 3\nbox 1 1 1 0"))
garble("pi_without_box", ("law", "law 3\npi 3 4"))
garble("pi_bounds_exchanged", ("pi", "pi 4 3"), base="box")
garble("pi_bounds_beyond_4", ("pi", "pi 3 4.1"), base="box")
garble("pi_of_1001_digits", ("pi", "pi 3." + "1" * 1001 + " 4"), base="box")
garble("particles_zero", ("particles", "particles 0"))
garble("leading_zero", ("particles", "particles 04"))
garble("plus_sign", ("particles", "particles +4"))
garble("trailing_zero_of_a_decimal", ("class 2", "class 2 1 2.50 2.5"))
garble("decimal_without_digits_behind_the_point", ("class 2", "class 2 1 2. 2.5"))
garble("exponent", ("class 2", "class 2 1 25e-1 2.5"))
garble("scale_not_in_lowest_terms", ("scale", "scale 34/4"))
garble("scale_zero", ("scale", "scale 0"))
garble("quantity_zero", ("class 2", "class 2 0 2.5 2.5"))
garble("lower_end_above_the_upper", ("class 2", "class 2 1 2.6 2.5"))
garble("lower_end_zero", ("class 2", "class 2 1 0 2.5"))
garble("classes_descend", ("class 1", "class 3 3 1 1"))
garble("class_of_19_digits", ("class 2", "class 1000000000000000002 1 2.5 2.5"))
garble("class_too_short", ("class 2", "class 2 1 2.5"))
garble("class_too_long", ("class 2", "class 2 1 2.5 2.5 2.5"))
garble("two_spaces", ("chain", "chain  2"))
garble("space_at_the_end", ("chain", "chain 2 "))
garble("tab", ("chain", "chain\t2"))
garble("chain_missing", ("chain", None))
garble("chain_where_none_is_needed", ("end", "chain 1\nend"), base="at_least_reached")
garble("above_without_at_least", ("chain", "above 1\nchain 2"))
garble("end_missing", ("end", None))
garble("empty_line", ("end", "\nend"))
garble("line_after_the_end", ("end", "end\nend"))
garble("number_of_100001_digits", ("particles", "particles 1" + "0" * 100000))
garble("powers_out_of_hand", ("law", "law 1000"), ("class 2", f"class 2 1 2.{'1' * 500} 2.{'1' * 500}"))
garble("band_file_and_lines", ("band file", "band file\nband 2 0 100"), base="band_alone")
garble("band_file_twice", ("band file", "band file\nband file"), base="band_alone")
for name, old, new in (
        ("leaf_without_conditions", "leaf 4 e1 4 E 4 x2 4 F2 12 Q2 3 m", "leaf"),
        ("leaf_breaks_off", "12 Q2 3 m", "12 Q2 3"),
        ("condition_unknown", "12 Q2", "12 Z2"),
        ("condition_without_its_class", "12 Q2", "12 Q"),
        ("condition_with_a_class_too_many", "12 Q2 3 m", "12 Q2 3 m1"),
        ("condition_of_class_zero", "12 Q2", "12 Q0"),
        ("condition_of_a_class_with_a_leading_zero", "12 Q2", "12 Q02"),
        ("condition_twice", "12 Q2", "6 Q2 6 Q2"),
        ("multiplier_zero", "12 Q2", "0 R1 12 Q2"),
        ("multiplier_negative", "12 Q2", "-12 Q2"),
        ("multiplier_fraction", "12 Q2", "25/2 Q2"),
        ("split_at_zero", "split 1 1", "split 1 0"),
        ("split_without_its_bound", "split 1 1", "split 1"),
        ("one_leaf_short", "leaf 4 e1 4 E 4 x2 3 f1 1 F2 3 N 6 q1\n", ""),
        ("one_leaf_too_many", "end\n", "leaf 1 m\nend\n"),
        ("no_tree", HAND[HAND.index("split 2"):], "end\n"),
        ("scale_in_it", "particles 3\n", "particles 3\nscale 1\n"),
        ("chain_in_it", "split 2 1\n", "chain 2\n"),
        ("class_without_a_mass", "class 1 1 3/2 1.5 1.5", "class 1 1 1.5 1.5"),
        ("mass_zero", "class 1 1 3/2 1.5 1.5", "class 1 1 0 1.5 1.5"),
        ("mass_not_in_lowest_terms", "class 1 1 3/2 1.5 1.5", "class 1 1 6/4 1.5 1.5"),
        ("no_particles_in_a_class", "class 1 1 3/2 1.5 1.5", "class 1 0 3/2 1.5 1.5"),
        ("none_with_a_witness", "particles 3\n", "particles none\n"),
        ("particles_zero", "particles 3\n", "particles 0\n"),
        ("tolerance_above_100", "total 10", "retained 100.1"),
        ("total_above_200", "total 10", "total 200.1"),
        ("tolerance_negative", "total 10", "total -1"),
        ("tolerance_twice", "total 10", "total 10\ntotal 10"),
        ("tolerances_out_of_order", "total 10", "total 10\nretained 5"),
        ("file_before_percent", "total 10", "retained file\nretained 5\ntotal 10"),
        ("total_of_the_file", "total 10", "total file"),
        ("passing_each_of_nothing", "total 10", "passing-each"),
        ("band_of_two_numbers", "total 10", "band 2 100"),
        ("band_that_descends", "total 10", "band 2 0 100\nband 1 0 100"),
        ("band_with_a_sieve_twice", "total 10", "band 2 0 100\nband 2 0 100"),
        ("no_tolerance", "total 10\n", "")):
    assert HAND.count(old) == 1, name
    unparsable["tree_" + name] = (BY_HAND, HAND.replace(old, new))
for name, old, new in (
        ("in_version_2", "mdm-certificate 3", "mdm-certificate 2"),
        ("in_version_1", "mdm-certificate 3", "mdm-certificate 1"),
        ("split_at_0", "split M 4", "split M 0"),
        ("split_at_a_decimal", "split M 4", "split M 4.5"),
        ("split_not_in_lowest_terms", "split M 4", "split M 8/2"),
        ("split_below_0", "split M 4", "split M -4"),
        ("split_without_a_mass", "split M 4", "split M"),
        ("split_of_two_masses", "split M 4", "split M 4 5"),
        ("split_of_a_class_of_mass", "split M 4", "split M1 4"),
        ("multiplier_0", "window 1 t", "window 0 t"),
        ("multiplier_fraction", "window 1 t", "window 1/2 t"),
        ("condition_twice", "window 1 t", "window 1 t 1 t"),
        ("condition_of_leaves", "window 1 t", "window 1 m"),
        ("condition_of_a_class", "window 1 t", "window 1 t 1 q1"),
        ("condition_of_a_share", "window 1 t", "window 1 t 1 r1"),
        ("condition_of_class_0", "window 1 t", "window 1 t 1 P0"),
        ("condition_d", "window 1 t", "window 1 t 1 d1-2"),
        ("sum_of_one_class", "window 1 t", "window 1 t 1 s2"),
        ("condition_t_of_a_class", "window 1 t", "window 1 t1"),
        ("leaf_with_a_condition_of_windows", "window 1 t", "leaf 1 t"),
        ("leaf_without_conditions", "window 1 t", "leaf"),
        ("window_breaks_off", "window 1 t", "window 1"),
        ("one_window_short", "window 1 t\n", "")):
    assert WINDOWS.count(old) == 1, name
    unparsable["tree_windows_" + name] = (OPEN_TABLE, WINDOWS.replace(old, new))
unparsable["tree_windows_of_mass_alone_in_version_2"] = (
    BY_HAND, HAND.replace("mdm-certificate 1", "mdm-certificate 2").replace("split 2 1", "split M 1"))
for name, particles in (("the_same", "4..4"), ("that_descend", "6..4"), ("from_zero", "0..6"), ("from_nothing", "..6"),
                        ("of_three", "4..5..6"), ("with_three_points", "4...6"), ("with_one_point", "4.6"), ("in_two_words", "4.. 6"),
                        ("with_a_leading_zero", "04..6"), ("with_a_sign", "-4..6"), ("of_nothing", ".."), ("of_none", "4..none"),
                        ("alone_with_a_witness", "4..")):
    garble("tree_bounds_" + name, ("particles", "particles " + particles), base=SUM_BOUND)
for name, particles in (("one", "1.."), ("zero", "0.."), ("with_one_point", "4."), ("with_a_sign", "+4..")):
    garble("tree_bound_alone_" + name, ("particles", "particles " + particles), base="tree_bound_alone")
for base in (SUM, SUM_BOUND, "tree_bound_alone"):
    garble(base + "_in_version_1", ("mdm-certificate", "mdm-certificate 1"), base=base)
garble("tree_bounds_of_an_exact_match", ("particles", "particles 3..4"))
garble("tree_split_of_a_sum_in_version_1", ("mdm-certificate", "mdm-certificate 1"), (STRICT_LEAF, "leaf 1 m"),
       ("leaf 40", "leaf 1 m"), base=SUM)
for name, classes in (("the_same", "2-2"), ("that_descend", "3-2"), ("without_a_last", "2-"), ("without_a_first", "-3"),
                      ("three", "1-2-3"), ("with_a_leading_zero", "2-03"), ("of_19_digits", "2-1000000000000000003")):
    garble("tree_split_of_classes_" + name, ("split 2-3 1", f"split {classes} 1"), base=SUM)
    garble("tree_condition_of_classes_" + name, (STRICT_LEAF, STRICT_LEAF.replace("s2-3", "s" + classes)), base=SUM)
for name, condition in (("of_one_class", "s2"), ("of_no_class", "s"), ("of_class_zero", "s0-3"), ("of_a_single_class", "f2-3"),
                        ("of_all_classes", "N2-3"), ("twice", "d2-3"), ("of_too_many_classes", "d1-4200000")):
    garble("tree_sum_" + name, (STRICT_LEAF, STRICT_LEAF.replace("s2-3", condition)), base=SUM)
unparsable["exact_particles_none"] = (TRIPLE, accepted["sphere_two_classes"][1].replace("particles 4", "particles none"))
base_csv, base_proof = accepted["sphere_two_classes"]
for name, proof in (("empty", ""), ("no_line_end", base_proof[:-1]), ("carriage_returns", base_proof.replace("\n", "\r\n")),
                    ("byte_order_mark", "\ufeff" + base_proof), ("gradation_twice", base_csv)):
    unparsable["certificate_" + name] = (base_csv, proof)
for name, text in {
        "empty": "", "header_alone": "size_mm,mass\n", "one_row": "size_mm,mass\n1,0\n",
        "no_header": "1,2\n2,1\n3,0\n", "size_unknown": "size,mass\n1,2\n2,1\n3,0\n",
        "column_unknown": "size_mm,mass,colour\n1,2,1\n2,1,1\n3,0,1\n",
        "column_twice": "size_mm,mass,factor,factor\n1,2,1,1\n2,1,1,1\n3,0,1,1\n",
        "one_column": "size_mm\n1\n2\n3\n", "short_row": "size_mm,mass\n1,2\n2\n3,0\n",
        "long_row": "size_mm,mass\n1,2\n2,1,1\n3,0\n", "text_as_mass": "size_mm,mass\n1,much\n2,1\n3,0\n",
        "nan": "size_mm,mass\n1,nan\n2,1\n3,0\n", "inf": "size_mm,mass\n1,2\n2,1\ninf,0\n",
        "exponent_beyond_400": "size_mm,mass\n1,2\n2,1e401\n3,0\n", "hexadecimal": "size_mm,mass\n0x1,2\n2,1\n3,0\n",
        "more_than_1000_digits": "size_mm,mass\n1,2\n2,1." + "0" * 1000 + "\n3,0\n",
        "negative_mass": "size_mm,mass\n1,2\n2,-1\n3,0\n", "negative_size": "size_mm,mass\n-1,2\n2,1\n3,0\n",
        "size_twice": "size_mm,mass\n1,2\n2,1\n2.0,1\n3,0\n", "pan_twice": "size_mm,mass\n0,2\npan,1\n3,0\n",
        "top_retains": "size_mm,mass\n1,2\n2,1\n3,1\n", "no_mass": "size_mm,mass\n1,0\n2,0\n3,0\n",
        "passing_101": "size_mm,passing_percent\n1,10\n2,101\n3,100\n",
        "passing_99_at_the_top": "size_mm,passing_percent\n1,10\n2,50\n3,99\n",
        "passing_decreases": "size_mm,passing_percent\n1,50\n2,10\n3,100\n",
        "passing_the_pan": "size_mm,passing_percent\n0,5\n2,10\n3,100\n",
        "passing_implies_a_pan_without_factor": "size_mm,passing_percent,factor\n1,5,1\n2,10,1\n3,100,1\n",
        "cumulative_not_0_at_the_top": "size_mm,cumulative_retained_percent\n1,90\n2,50\n3,1\n",
        "factor_zero": "size_mm,mass,factor\n1,2,1\n2,1,0\n3,0,1\n",
        "tolerance_negative": "size_mm,mass,tolerance_percent\n1,2,1\n2,1,-1\n3,0,1\n",
        "sieve_unknown": "sieve,mass\nNo. 9,2\nNo. 8,1\nNo. 4,0\n",
        "sieve_without_unit": "sieve,mass\n1,2\n2,1\n3,0\n",
        "sieve_negative": "sieve,mass\n-1 mm,2\n2 mm,1\n3 mm,0\n",
        "phi_beyond_1000": "size_phi,mass\n1000.5,2\n2,1\n-3,0\n",
        "phi_of_a_root_beyond_1000": "size_phi,mass\n1.0001,2\n0,1\n-3,0\n",
        "phi_of_a_common_root_beyond_1000": "size_phi,mass\n1.0625,2\n0.008,1\n-3,0\n",
        "phi_of_many_digits": "size_phi,mass\n1e-300,2\n0,1\n-3,0\n",
        "phi_that_need_too_much_memory": "size_phi,mass\n" + "".join(f"{i / 1000:.3f},1\n" for i in range(999000, 999300)) +
        "0,0\n",
        "comma_and_point": "size_mm;mass\n1,0;2\n2.0;1\n3;0\n", "comma_with_comma": "size_mm,mass\n1,0,2\n2,0,1\n3,0,0\n",
        "open_quote": "size_mm,mass\n\"1,2\n2,1\n3,0\n", "text_behind_a_quote": "size_mm,mass\n\"1\"x,2\n2,1\n3,0\n",
        "lone_carriage_return": "size_mm,mass\n1,2\r2,1\n3,0\n", "control_character": "size_mm,mass\n1,2\n2,1\n3,0\n\x01\n",
        "number_behind_a_hash": "size_mm,mass\n#4,50\n1,2\n2,1\n3,0\n",
        "number_behind_a_hash_before_the_header": "#4 sands\nsize_mm,mass\n1,2\n2,1\n3,0\n",
        "number_behind_a_hash_behind_blanks": "size_mm,mass\n1,2\n2,1\n \t#10 US\n3,0\n",
        "number_behind_a_hash_of_sieves": "sieve,mass\n#12,1\nNo. 10,2\nNo. 8,1\nNo. 4,0\n",
        "number_behind_a_hash_and_blanks_of_sieves": "sieve,mass\n# \t12,1\nNo. 10,2\nNo. 8,1\nNo. 4,0\n",
        "line_separator": "# note\u20281,500\nsize_mm,mass\n1,2\n2,1\n3,0\n",
        "paragraph_separator": "size_mm,mass\n1,2\n2,1\n3,0\n#\u2029",
        "next_line": "# note\u00851,500\nsize_mm,mass\n1,2\n2,1\n3,0\n",
        **{f"direction_{code:04X}": f"size_mm,mass\n1,2\n2,1\n3,0\n# {chr(code)}"
           for code in (0x61C, 0x200E, 0x200F, 0x202A, 0x202E, 0x2066, 0x2069)},
        "carriage_return_in_a_comment": "# lab 7\r1,40\nsize_mm,mass\n1,2\n2,1\n3,0\n",
        "carriage_return_at_the_end": "size_mm,mass\n1,2\n2,1\n3,0\r",
        "carriage_return_twice": "size_mm,mass\r\r\n1,2\r\n2,1\r\n3,0\r\n",
        "carriage_return_in_quotes": "size_mm,mass\n\"1\r\",2\n2,1\n3,0\n",
        "carriage_return_on_an_empty_line": "size_mm,mass\n1,2\n \r \n2,1\n3,0\n",
        "pan_in_quotes_with_a_blank": "size_mm,mass\n\"pan \",2\n2,1\n3,0\n",
        "number_in_quotes_with_a_blank": "size_mm,mass\n\" 1\",2\n2,1\n3,0\n",
        "header_in_quotes_with_a_blank": "\"size_mm \",mass\n1,2\n2,1\n3,0\n",
        "ags4": '"GROUP","GRAT"\n"HEADING","GRAT_SIZE"\n',
}.items():
    unparsable["csv_" + name] = (text, base_proof)
for name, text in {
        "without_rows": "", "that_lets_less_than_all_pass": "1,0,0\n2,0,99\n", "below_0": "1,-1,0\n2,0,100\n",
        "above_100": "1,0,101\n2,0,100\n", "of_the_pan": "0,1,2\n2,0,100\n", "with_a_size_twice": "1,0,0\n1.0,0,5\n2,0,100\n",
        "of_the_pan_alone": "pan,0,100\n", "of_a_negative_size": "-1,0,0\n2,0,100\n"}.items():
    unparsable["band_" + name] = ("size_mm,passing_min_percent,passing_max_percent\n" + text, accepted["band_alone"][1])
for name, header in (("with_a_tolerance", "size_mm,passing_min_percent,passing_max_percent,tolerance_percent"),
                     ("of_exchanged_columns", "size_mm,passing_max_percent,passing_min_percent"),
                     ("of_masses", "size_mm,passing_min_percent,mass")):
    fields = ",0" * (header.count(",") - 2)
    unparsable["band_" + name] = (f"{header}\n1,0,0{fields}\n2,0,100{fields}\n", accepted["band_alone"][1])
unparsable["band_of_half_phi"] = ("size_phi,passing_min_percent,passing_max_percent\n0.5,0,0\n-1,0,100\n",
                                  accepted["band_in_phi"][1])
for name, text in {
        "array": '[1, 2]', "broken_off": '{"sizes": [1, 2, 3], "masses": [2, 1, 0]', "no_masses": '{"sizes": [1, 2, 3]}',
        "followed": '{"sizes": [1, 2, 3], "masses": [2, 1, 0]} 1', "key_twice":
        '{"sizes": [1, 2, 3], "masses": [2, 1, 0], "s\\u0069zes": [1, 2, 3]}',
        "key_factor": '{"sizes": [1, 2, 3], "masses": [2, 1, 0], "factor": [1, 2, 3]}',
        "key_units": '{"sizes": [1, 2, 3], "masses": [2, 1, 0], "units": "in"}',
        "key_unknown": '{"sizes": [1, 2, 3], "masses": [2, 1, 0], "note": null}',
        "key_of_another_case": '{"Sizes": [1, 2, 3], "sizes": [1, 2, 3], "masses": [2, 1, 0]}',
        "id_1e309": '{"id": 1e309, "sizes": [1, 2, 3], "masses": [2, 1, 0]}',
        "id_of_1001_digits": '{"id": 1.' + "0" * 1000 + ', "sizes": [1, 2, 3], "masses": [2, 1, 0]}',
        "id_of_another_direction": '{"id": "a\u202e", "sizes": [1, 2, 3], "masses": [2, 1, 0]}',
        "id_null": '{"id": null, "sizes": [1, 2, 3], "masses": [2, 1, 0]}',
        "lone_carriage_return": '{"sizes": [1, 2, 3],\r"masses": [2, 1, 0]}',
        "lengths_differ": '{"sizes": [1, 2, 3], "masses": [2, 0]}', "unit_unknown":
        '{"unit": "ft", "sizes": [1, 2, 3], "masses": [2, 1, 0]}', "unit_number":
        '{"unit": 1, "sizes": [1, 2, 3], "masses": [2, 1, 0]}', "id_array":
        '{"id": [], "sizes": [1, 2, 3], "masses": [2, 1, 0]}', "unsorted": '{"sizes": [1, 3, 2], "masses": [2, 1, 0]}',
        "number_1e309": '{"sizes": [1, 2, 1e309], "masses": [2, 1, 0]}', "number_1e401":
        '{"sizes": [1, 2, 3], "masses": [2, 1e401, 0]}', "leading_zero": '{"sizes": [01, 2, 3], "masses": [2, 1, 0]}',
        "string_with_a_space": '{"sizes": ["1 ", 2, 3], "masses": [2, 1, 0]}', "comma_at_the_end":
        '{"sizes": [1, 2, 3,], "masses": [2, 1, 0]}', "half_a_surrogate_pair":
        '{"id": "\\ud800", "sizes": [1, 2, 3], "masses": [2, 1, 0]}', "factor_zero":
        '{"sizes": [1, 2, 3], "masses": [2, 1, 0], "factors": [1, 0, 1]}',
}.items():
    unparsable["json_" + name] = (text, base_proof)

for verdict, tests in (("accepted", accepted), ("rejected", rejected), ("unparsable", unparsable)):
    folder = FOLDER / verdict
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for name, (gradation, proof) in tests.items():
        json = gradation.lstrip().startswith("{")
        (folder / (name + (".json" if json else ".csv"))).write_bytes(gradation.encode())
        (folder / (name + ".proof")).write_bytes(proof.encode())
blends.main(FOLDER / "blends")
sample_cases.main(FOLDER / "samples")
