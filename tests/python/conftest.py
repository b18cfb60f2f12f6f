"""What tests and doctests have at hand."""

from decimal import Decimal
from fractions import Fraction

import exactmdm
import hypothesis
import pytest
import support  # noqa: F401

hypothesis.settings.register_profile("project", database=None, deadline=None, derandomize=True, max_examples=60)
hypothesis.settings.load_profile("project")


@pytest.fixture(autouse=True)
def names(doctest_namespace):
    """The names that doctests use."""
    doctest_namespace.update(exactmdm=exactmdm, Fraction=Fraction, Decimal=Decimal)
