"""Certificates of version 3, in fractions: trees with splits of the mass and the leaves of its windows. A leaf is found
as a solution of linear inequalities about every point that a class can have, one count after the other."""
from fractions import Fraction as F

from trees import Tree, first_phase, whole

# Rules that are wrong. Certificates that they accept must be refused.
MUTATIONS = ("counts from one more", "counts at an end", "upper ends open", "lower ends open", "no class without share",
             "empty classes open", "greatest counts left out", "without rays")


class WindowTree(Tree):
    """masses: where M is split; plain: whether leaves of conditions are tried first; wrong: a rule of MUTATIONS."""

    most_counts = 200

    def __init__(self, *arguments, masses=(), plain=False, wrong=None, give_up=400, **question):
        self.masses_of_splits, self.plain, self.wrong, self.give_up = sorted(F(v) for v in masses), plain, wrong, give_up
        super().__init__(*arguments, **question)

    def version(self):
        return 3

    def bounds_of_shares(self):
        """[l, h] of each class: the longest paths between neighbours, P_0 = 0 and P_k = 1."""
        k, half = self.k, self.e / 2
        edges = [(0, k, F(1)), (k, 0, F(-1))]
        G = F(0)
        for j in range(k):
            lo, hi = self.retained[j]
            edges += [(j, j + 1, max(F(0), lo, self.g[j] - half)), (j + 1, j, -min(F(1), hi, self.g[j] + half))]
            G += self.g[j]
            lo, hi = self.passing[j]
            if j + 1 < k:
                edges += [(0, j + 1, max(lo, G - half)), (j + 1, 0, -min(hi, G + half))]
        least = [[F(0) if a == b else None for b in range(k + 1)] for a in range(k + 1)]
        for _ in range(k + 1):
            for row in least:
                for a, b, weight in edges:
                    if row[a] is not None and (row[b] is None or row[a] + weight > row[b]):
                        row[b] = row[a] + weight
        return [(least[j][j + 1], -least[j + 1][j]) for j in range(k)]

    def counts_of(self, j, s, S, least, most):
        l, h = self.of_share[j]
        a, b = least, most
        if l > 0:
            a = max(a, l * s // self.F[j] + 1)
            if self.wrong == "counts from one more" and s > 0 and (l * s / self.F[j]).denominator == 1:
                a += 1
        if h <= 0 and self.wrong != "no class without share":
            b = 0
        elif self.f[j] > 0 and S is not None:
            top = -(-h * S // self.f[j]) - 1
            b = top if b is None else min(b, top)
            if self.wrong == "greatest counts left out":
                b = max(a, b - 1)
        return a, b

    def points(self, j, s, S, least, most):
        """(q, y, whether the class has it, not only comes near) of all counts, and whether there are more counts."""
        l, h = self.of_share[j]
        a, b = self.counts_of(j, s, S, least, most)
        ends = b
        if b is None:
            sizes = [(s, self.F[j])] + ([(S, self.f[j])] if S and self.f[j] else [])
            ends = max(a, *(int(share * mass / size) + 3 for mass, size in sizes for share in (l, h, self.g[j])))
        if ends - a > self.most_counts:
            raise ValueError("too many counts")
        points = []
        for q in range(a, ends + 1):
            if q == 0:
                points.append((0, F(0), self.wrong != "empty classes open"))
                continue
            low, high = F(0) if S is None else q * self.f[j] / S, None if s == 0 else q * self.F[j] / s
            has_low, has_high = low < l, high is None or high > h
            low, high = max(low, l), h if high is None else min(high, h)
            has_low = has_low and self.wrong != "lower ends open"
            has_high = has_high and self.wrong != "upper ends open"
            points += [(q, low, has_low), (q, high, has_high)]
            if low < self.g[j] < high:
                points.append((q, self.g[j], True))
            elif low < high and not (has_low and has_high):
                points.append((q, (low + high) / 2, True))
        return points, b is None and self.wrong != "without rays"

    def window_conditions(self, S, of_sums):
        """name: (what a class has with q particles and the share y, right side)."""
        k = self.k
        rows = {"t": (lambda j, q, y: y, F(1)), "T": (lambda j, q, y: -y, F(-1)),
                "E": (lambda j, q, y: -max(F(0), y - self.g[j]), -self.e / 2),
                "n": (lambda j, q, y: F(q), F(self.at_least))}
        if self.weight:
            rows["w"] = (lambda j, q, y: y / self.c[j], self.weight / S if S else F(0))
        if self.B:
            rows["N"] = (lambda j, q, y: F(-q), F(1 - self.B))
        for last in range(k):
            lo, hi = self.passing[last]
            rows[f"p{last + 1}"] = (lambda j, q, y, last=last: y if j <= last else F(0), lo)
            rows[f"P{last + 1}"] = (lambda j, q, y, last=last: -y if j <= last else F(0), -hi)
        for (i, j), (low, high) in of_sums.items():
            rows[f"s{i + 1}-{j + 1}"] = (lambda b, q, y, i=i, j=j: F(q) if i <= b <= j else F(0), F(low))
            if high is not None:
                rows[f"S{i + 1}-{j + 1}"] = (lambda b, q, y, i=i, j=j: F(-q) if i <= b <= j else F(0), F(-high))
        return {name: row for name, row in rows.items() if name[0] not in self.avoid}

    def window_leaf(self, s, S, least, most, of_sums):
        """Multiples that make the greatest sum of all classes less than the right sides demand; or None."""
        self.of_share = self.bounds_of_shares()
        counts = [self.counts_of(j, s, S, least[j], most[j]) for j in range(self.k)]
        if any(b is not None and a > b for a, b in counts):
            return []
        conditions = self.window_conditions(S, of_sums)
        names = sorted(conditions)
        points, rays = [], []
        for j in range(self.k):
            of_class, has_ray = self.points(j, s, S, least[j], most[j])
            points += [(j, *point) for point in of_class]
            rays += [j] if has_ray else []
        # Weights of a class's points add up to a number that all classes share: 1; or, where the points that class
        # `tied` has weigh 1, any. If no weights meet the conditions, multiples of these show it.
        for tied in (None, *range(self.k)):
            columns = [[conditions[n][0](j, q, y) for n in names] + [F(i == j) for i in range(self.k)] +
                       [F(j == tied and is_reached)] for j, q, y, is_reached in points]
            columns += [[conditions[n][0](j, 1, F(0)) for n in names] + [F(0)] * (self.k + 1) for j in rays]
            columns.append([-conditions[n][1] for n in names] + [F(-1)] * self.k + [F(tied is None)])
            columns += [[-F(i == n) for i in range(len(names))] + [F(0)] * (self.k + 1) for n in range(len(names))]
            multiples = first_phase(columns, [F(0)] * (len(names) + self.k) + [F(1)])[1]
            if multiples:
                multiples = multiples[:len(names)]
                return whole(multiples, names) if any(multiples) else []
        return None

    def grow(self, least, most, of_sums, sums):
        self.size = 0
        self.grow_window(F(0), None, least, most, of_sums, list(self.masses_of_splits), sums)

    def grow_window(self, s, S, least, most, of_sums, masses, sums):
        self.size += 1
        if self.size > self.give_up:
            raise ValueError("the tree becomes too large")
        if self.plain and (leaf := self.leaf(least, most, of_sums)):
            self.nodes.append(["leaf", leaf])
            return
        leaf = self.window_leaf(s, S, least, most, of_sums)
        if leaf is not None:
            self.nodes.append(["window", leaf])
            return
        if masses:
            v = masses[len(masses) // 2]
            self.nodes.append(["split", "M", v])
            self.grow_window(s, v, least, most, of_sums, [m for m in masses if m < v], sums)
            self.grow_window(v, S, least, most, of_sums, [m for m in masses if m > v], sums)
            return
        if sums:
            i, j, v = sums[0]
            low, high = of_sums.get((i - 1, j - 1), (0, None))
            self.nodes.append(["split", f"{i}-{j}", v])
            below = (low, v - 1 if high is None else min(high, v - 1))
            self.grow_window(s, S, least, most, {**of_sums, (i - 1, j - 1): below}, [], sums[1:])
            self.grow_window(s, S, least, most, {**of_sums, (i - 1, j - 1): (max(low, v), high)}, [], sums[1:])
            return
        if self.B is None:
            raise ValueError("no bound on counts")
        top = [self.B - 1 if u is None else u for u in most]
        if all(a >= b for a, b in zip(least, top)):
            leaf = self.leaf(least, most, of_sums)
            if not leaf:
                raise ValueError("no leaf")
            self.nodes.append(["leaf", leaf])
            return
        j = max(range(self.k), key=lambda i: (least[i] < top[i], least[i] == 0, top[i] - least[i]))
        v = 1 if least[j] == 0 else (least[j] + top[j] + 1) // 2
        self.nodes.append(["split", j + 1, v])
        self.grow_window(s, S, least, [v - 1 if i == j else u for i, u in enumerate(most)], of_sums, [], ())
        self.grow_window(s, S, [v if i == j else u for i, u in enumerate(least)], most, of_sums, [], ())
