"""What an entry of the catalogue says of a figure."""

import pytest

from wrinklestudy.study.catalogue import Catalogue, FigureEntry, TableEntry


def entry(**changes):
    text = {"name": "dot", "title": "dot", "caption": "A dot.", "module": "toy.dot"}
    return FigureEntry(**text | changes)


@pytest.mark.parametrize(
    ("wanted", "available", "shown"),
    [
        ((0.0, 0.1, 0.2, 0.32, 0.46), [0.5, 0.1, 0.22, 0.3], [0.1, 0.22, 0.3, 0.5]),
        ((0.0, 0.1, 0.2), [0.1], [0.1]),
        ((0.15,), [0.2, 0.1], [0.1]),
        ((0.1,), [], []),
        ("all", [0.3, 0.1], [0.1, 0.3]),
        ((), [0.3, 0.1], []),
    ],
)
def test_the_states_of_a_figure_are_the_nearest_that_were_computed(wanted, available, shown):
    assert entry(strains=wanted).strains_shown(available) == shown


def test_a_figure_that_is_not_there_is_refused_with_those_that_are():
    catalogue = Catalogue(name="toy", title="Toy", figures=(entry(), entry(name="line")))
    assert catalogue.figure("line").name == "line"
    with pytest.raises(ValueError, match=r"figure 'circle': must be one of dot, line"):
        catalogue.figure("circle")


def test_a_table_does_not_take_the_place_of_the_claims():
    with pytest.raises(ValueError, match="table 'claims': the table of claims has this name"):
        TableEntry(name="claims", title="a", caption="b", module="c")
