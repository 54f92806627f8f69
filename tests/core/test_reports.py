import re
from xml.etree import ElementTree

import pytest

from semref.core.evaluation.rates import Rate
from semref.processing.layers import palette
from semref.processing.reports import charts, page
from semref.processing.reports.charts import Series

HOSTILE = 'a <b> & "c"</script>'
SVG = "{http://www.w3.org/2000/svg}"


def drawn(svg):
    return ElementTree.fromstring(svg)


LINE = Series(HOSTILE, [0.0, 0.25, 0.5], [0.0, 1.0, 0.5], [0.0, 0.9, 0.4], [0.1, 1.0, 0.6])
X, Y = charts.linear_axis(HOSTILE, 0.5), charts.percent_axis("right")


def every_chart():
    return [
        charts.line_chart([LINE], X, Y, HOSTILE),
        charts.line_chart([Series("s", [1, 10], [0.2, 0.4], stepped=True)], charts.logarithmic_axis("m", 1, 9), Y, "e"),
        charts.line_chart([LINE], Y, Y, "reliability", diagonal=True),
    ]


@pytest.mark.parametrize("svg", every_chart())
def test_charts_are_whole_xml_with_a_name_and_stay_inside(svg):
    root = drawn(svg)
    _, _, width, height = (float(value) for value in root.get("viewBox").split())
    assert root.get("aria-label") == root.find(f"{SVG}title").text
    for element in root.iter(f"{SVG}path"):
        for x, y in re.findall(r"[ML](-?[\d.]+) (-?[\d.]+)", element.get("d")):
            assert 0 <= float(x) <= width and 0 <= float(y) <= height


def test_a_logarithmic_axis_has_whole_decades():
    axis = charts.logarithmic_axis("m", 0.03, 2000)
    assert axis.limits == (0.01, 10000)
    assert [text for _, text in axis.ticks] == ["0.01", "0.1", "1", "10", "100", "1,000", "10,000"]
    assert (axis.place(0.0), axis.place(0.01), axis.place(10.0), axis.place(1e9)) == (0, 0, pytest.approx(0.5), 1)


def test_a_page_needs_no_network_and_no_script():
    html = page.page("title", "subtitle", *every_chart())
    assert html.startswith("<!DOCTYPE html>")
    assert not re.search(r"<script|<link|@import|url\(|\bsrc=|\bhref=", html)


def test_texts_are_escaped_everywhere():
    html = page.page(
        HOSTILE,
        HOSTILE,
        page.section(HOSTILE, page.paragraph(HOSTILE), page.table([HOSTILE], [[HOSTILE]])),
        page.key_figures([(HOSTILE, HOSTILE, HOSTILE)]),
        page.figure("", HOSTILE),
        *every_chart(),
    )
    assert "<b> &" not in html and "</script>" not in html and "&lt;b&gt; &amp;" in html


def test_a_table_aligns_numbers_marks_good_and_bad_and_shades_shares():
    html = page.table(["a", "b"], [[page.Marked("yes", True), "1"], [page.Marked("no", False), "2"]], [1])
    assert html.count('class="number"') == 3
    assert '<td class="good">yes</td>' in html and '<td class="bad">no</td>' in html
    html = page.table(["a", "b", "c"], [[page.Shaded(HOSTILE, 1.0), page.Shaded("50 %", 0.5), page.Shaded("–", None)]])
    assert html.count("style=") == 2 and ",0.70)" in html and ",0.35)" in html and "<b> &" not in html


def test_numbers_have_units_and_unknown_values_are_dashes():
    assert page.number(0.08869, "m") == "0.0887\u00a0m"
    assert (page.number(12345.6), page.number(2.04, "°", 2), page.number(None, "m")) == ("12,346", "2°", "–")
    assert (page.percent(0.125), page.percent(None)) == ("12.5\u00a0%", "–")
    assert page.rate_text(Rate(95, 100)) == f"95.0\u00a0% (88.8{page.DASH}97.8\u00a0%, 95/100)"
    assert page.rate_text(Rate(0, 0)) == "–"


def test_no_two_of_sixteen_lines_look_the_same():
    chart = charts.line_chart([Series(str(n), [0.0, 0.5], [0.1, 0.5]) for n in range(16)], X, Y, "lines")
    # The legend has a piece of each line with its marker.
    pieces = re.findall(
        r'<path d="M[\d.]+ [-\d.]+h24" style="([^"]+)"></path>\n<(\w+) (?:d="M[\d. -]+m([^"]+)")?', chart
    )
    assert len(pieces) == 16 and len(set(pieces)) == 16


def test_a_page_has_the_colors_of_the_maps_and_a_list_of_what_to_do_next():
    style = page.page("t", "s")
    for color in (palette.FIX, palette.FLIGHT, palette.BAD):
        assert style.count(color) >= 2
        assert palette.DARK[color] in style
    assert "prefers-color-scheme: dark" in style and "@page" in style
    assert page.macros().next_steps("Next", ["Do <this>."]).count("<li>Do &lt;this&gt;.</li>") == 1


@pytest.mark.parametrize("second", ["Automatic", "Published method (He & Wu 2025)", "二维拓扑向量（论文发表的方法）"])
def test_no_entry_of_a_legend_runs_out_of_its_chart_or_into_the_next_one(second):
    names = ["Constellation", second, "b"]
    svg = charts.line_chart([Series(name, [0.0, 0.5], [0.0, 1.0]) for name in names], X, Y, "lines")
    entries = [one for one in drawn(svg).iter(f"{SVG}text") if one.text in names]
    assert [one.text for one in entries] == names
    rows = {}
    for one in entries:
        rows.setdefault(float(one.get("y")), []).append((float(one.get("x")), len(one.text.encode("gb18030"))))
    for row in rows.values():
        # A letter is at most about 6.5 pixels wide, a Chinese character twice as wide.
        ends = [x + 6.5 * letters for x, letters in row]
        starts = [x - 30 for x, _ in row[1:]] + [charts.WIDTH]
        assert all(end <= start for end, start in zip(ends, starts))
