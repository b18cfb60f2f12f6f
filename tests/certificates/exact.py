"""Texts and roots of exact numbers."""


def decimal(value):
    """The canonical text of a decimal fraction."""
    places = 0
    while (value * 10**places).denominator != 1:
        places += 1
    digits = str(value * 10**places).rjust(places + 1, "0")
    return digits if places == 0 else digits[:-places] + "." + digits[-places:]


def root(n, degree):
    """floor of the root of an integer."""
    low, high = 0, 1 << (n.bit_length() // degree + 1)
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if middle**degree <= n else (low, middle)
    return low


def floor_root(value, degree):
    return root(value.numerator // value.denominator, degree)


def enclose(T, a, lower, upper, places, d=1):
    """Decimals around the root of T to the degree a, ten digits and more, in the class (lower, upper] of openings to
    the power d."""
    while True:
        n = floor_root(T * 10**(places * a), a)
        lo = type(T)(n, 10**places)
        hi = lo if lo**a == T else type(T)(n + 1, 10**places)
        if lower < lo**d and hi**d <= upper and 10**9 * (hi - lo) <= lo:
            return decimal(lo), decimal(hi)
        places += 1
