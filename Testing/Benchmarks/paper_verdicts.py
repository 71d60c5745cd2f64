# SPDX-License-Identifier: BSD-3-Clause
"""Sentences about the numbers: every one is computed, for any outcome of the measurement."""

from statistics import median

from paper_data import (
    ABLATED,
    CONTROLS,
    DISTRIBUTIONS,
    NMAX,
    by_control,
    by_nmax,
    exponent,
    gain,
    gains,
    span,
    tolerance,
)

INSIDE = [50, 100, 200]  # where the paper finds Nmax best


def percents(values):
    return span(values, "{:.1f}") + " %"


def times(count, of):
    return "all" if count == of else "none" if count == 0 else f"{count}"


def of_cases(count, of):
    """'in all 30 cases', 'in 12 of 30 cases', 'in none of 30 cases'."""
    if of == 1:
        return "in the one case" if count else "not in the one case"
    return f"in all {of} cases" if count == of else f"in {times(count, of)} of {of} cases"


def less_or_more(values, what="time"):
    """'3.1 to 4.5 % less time' for gains in percent, whatever their signs."""
    values = [round(value, 1) for value in values]
    if not values:
        return "not measured"
    low, high = min(values), max(values)
    if low >= 0:
        return f"{percents(values)} less {what}"
    if high <= 0:
        return f"{percents(-v for v in values)} more {what}"
    return f"from {-low:.1f} % more to {high:.1f} % less {what}"


# --- The claims of the paper, one by one -----------------------------------------------------------
# Each takes rows (the paper's or those measured here) and returns (cases in which it holds, all cases,
# detail); no cases: not known.


def lowest(rows, column):
    """HG has the lowest value of RG, MG, HG."""
    holding, others = [], []
    for case in rows.cases():
        rg, mg, hg = (rows.value(*case, c, column) for c in ("RG", "MG", "HG"))
        if None not in (rg, mg, hg):
            (holding if hg < min(rg, mg) else others).append(case)
    where = [d for d in DISTRIBUTIONS if any(d == case[1] for case in others)]
    detail = "not for " + ", ".join(where) if where else ""
    return len(holding), len(holding) + len(others), detail


def faster(rows, of, over):
    found = gains(rows, of, over).values()
    return sum(v > 0 for v in found), len(found), less_or_more(found) if found else ""


def at_least_ten(rows):
    """HG takes 10 to 20 % less time than CGAL, or less than that."""
    found = list(gains(rows, "HG", "CGAL").values())
    inside = sum(10 <= v <= 20 for v in found)
    more, less = sum(v > 20 for v in found), sum(v < 10 for v in found)
    parts = [less_or_more(found)] if found else []
    parts += [f"median {median(found):.1f} %"] if found else []
    parts += [f"{more} above 20 %"] * bool(more) + [f"{less} below 10 %"] * bool(less)
    return inside + more, len(found), ", ".join(parts)


def alike_if_uniform(rows):
    """RG and MG have the same NP and NR for uniform points, to the two decimals of the paper."""
    apart = []
    for points in rows.sizes:
        pairs = [(rows.value(points, "Uniform", c, k) for c in ("RG", "MG")) for k in ("np", "nr")]
        pairs = [tuple(pair) for pair in pairs]
        if all(None not in pair for pair in pairs):
            apart.append(max(abs(a - b) for a, b in pairs))
    detail = f"largest difference {max(apart):.2f}" if apart else ""
    return sum(a <= 0.01 for a in apart), len(apart), detail


def nearly_linear(rows):
    found = [exponent(rows, d, "HG") for d in DISTRIBUTIONS]
    found = [b for b in found if b is not None]
    return sum(b <= 1.1 for b in found), len(found), f"exponent {span(found, '{:.3f}')}" if found else ""


def even(rows):
    """The slowest distribution takes at most 1.15 times the time of the fastest, with HG."""
    ratios = []
    for points in rows.sizes:
        found = [rows.value(points, d, "HG", "total") for d in DISTRIBUTIONS]
        if None not in found:
            ratios.append(max(found) / min(found))
    detail = f"slowest/fastest {span(ratios, '{:.2f}')}" if ratios else ""
    return sum(r <= 1.15 for r in ratios), len(ratios), detail


def growing_lead(rows):
    """HG's gain over CGAL is larger for the most points than for the fewest (mixed)."""
    if len(rows.sizes) < 2:
        return 0, 0, ""
    ends = [gain(rows, (n, "Mixed"), "HG", "CGAL") for n in (rows.sizes[0], rows.sizes[-1])]
    if None in ends:
        return 0, 0, ""
    return int(ends[1] > ends[0]), 1, f"from {ends[0]:.1f} to {ends[1]:.1f} %"


CLAIMS = [
    ("HG has the lowest NP of RG, MG and HG", lambda rows: lowest(rows, "np")),
    ("HG has the lowest NR of RG, MG and HG", lambda rows: lowest(rows, "nr")),
    ("HG is faster than RG", lambda rows: faster(rows, "HG", "RG")),
    ("HG is faster than MG", lambda rows: faster(rows, "HG", "MG")),
    ("HG is faster than CGAL", lambda rows: faster(rows, "HG", "CGAL")),
    ("HG takes at least 10 % less time than CGAL (the text: 10 to 20 %)", at_least_ten),
    ("HG's lead over CGAL, in percent, grows with the number of points (mixed)", growing_lead),
    ("RG and MG are the same for uniform points (NP and NR within 0.01)", alike_if_uniform),
    ("HG's time is quasi-linear (here: grows with an exponent of at most 1.1)", nearly_linear),
    ("HG hardly depends on the distribution (here: slowest at most 1.15 times the fastest)", even),
]


def claim_rows(here, paper):
    """(claim, in the paper's own tables, here) of each claim."""
    result = []
    for claim, check in CLAIMS:
        cells = []
        for rows in (paper, here):
            holding, of, detail = check(rows)
            said = f"{of_cases(holding, of)}" if of else "not measured"
            cells.append(f"{said}; {detail}" if of and detail else said)
        result.append((claim, *cells))
    return result


# --- The ablations ---------------------------------------------------------------------------------


def total(rows, points, distribution, configuration):
    return rows.value(points, distribution, configuration, "total")


def gains_of_pairs(rows, points, pairs, column):
    """For the pairs (distribution, with, without): the gain of `with`, in percent, where known."""
    found = (gain(rows, (points, d), of, over, column) for d, of, over in pairs)
    return [value for value in found if value is not None]


def split_sentence(values, delta):
    n = len(values)
    faster_in, slower_in = sum(v > delta for v in values), sum(v < -delta for v in values)
    equal = n - faster_in - slower_in
    return (
        f"faster in {times(faster_in, n)}, slower in {times(slower_in, n)}, "
        f"within {delta:.1f} % in {times(equal, n)} of {n}"
    )


def work_change(rows, points, pairs, column):
    """'NP changed by -0.08 to +0.02'."""
    changes = []
    for distribution, of, over in pairs:
        a, b = (rows.value(points, distribution, c, column) for c in (of, over))
        if a is not None and b is not None:
            changes.append(a - b)
    return f"{column.upper()} changed by {span(changes, '{:+.2f}')}"


def effect(rows, points, what, pairs):
    """The effect of a setting: by insertion alone first, as orders are made in other ways than the paper's."""
    inserting = gains_of_pairs(rows, points, pairs, "insert")
    in_all = gains_of_pairs(rows, points, pairs, "total")
    if not inserting:
        return f"{what}: not measured."
    delta = tolerance(rows, "insert")
    work = ", ".join(work_change(rows, points, pairs, column) for column in ("np", "nr"))
    return (
        f"{what}: insertion took {less_or_more(inserting)} ({split_sentence(inserting, delta)}); "
        f"in total {less_or_more(in_all)}. {work}."
    )


def gene_sentences(rows, points):
    names = {
        "none": "without control points",
        "one": "with one level of control points",
        "every": "with control points at every level",
    }
    return [
        effect(
            rows,
            points,
            f"**Genes on instead of off**, {names[control]}",
            [(d, by_control(control, "on"), by_control(control, "off")) for d in ABLATED],
        )
        for control in CONTROLS
    ]


def control_sentences(rows, points):
    steps = [
        ("one", "none", "One level of control points instead of none"),
        ("every", "one", "Every level instead of one"),
    ]
    return [
        effect(
            rows,
            points,
            f"**{what}**, genes on",
            [(d, by_control(with_, "on"), by_control(without, "on")) for d in ABLATED],
        )
        for with_, without, what in steps
    ]


def nmax_cases(rows, points):
    """{(order, distribution): {nmax: total}} where all of them were measured."""
    found = {}
    for order in ("MG", "HG"):
        for distribution in ABLATED:
            totals = {n: total(rows, points, distribution, by_nmax(order, n)) for n in NMAX}
            if None not in totals.values():
                found[(order, distribution)] = totals
    return found


def outside_lead(totals):
    """By how many percent the best Nmax outside 50 to 200 beats the best inside; negative if it does not."""
    inside = min(totals[n] for n in INSIDE)
    outside = min(t for n, t in totals.items() if n not in INSIDE)
    return 100 * (inside - outside) / inside


def nmax_sentences(rows, points):
    cases = nmax_cases(rows, points)
    if not cases:
        return ["Not measured."]
    delta = tolerance(rows)
    leads = {case: outside_lead(totals) for case, totals in cases.items()}
    against = {case: v for case, v in leads.items() if v > delta}
    pro = sum(v < -delta for v in leads.values())
    n, open_ = len(cases), len(cases) - len(against) - pro
    best = ", ".join(
        f"{order} {distribution} {min(totals, key=totals.get)}"
        for (order, distribution), totals in cases.items()
    )
    spread = [100 * (max(t.values()) / min(t.values()) - 1) for t in cases.values()]
    fifty = [100 * (t[50] / min(t.values()) - 1) for t in cases.values()]
    sentences = [
        f"The fastest Nmax: {best}. From the fastest to the slowest of {NMAX[0]} to {NMAX[-1]}: "
        f"{percents(spread)} more time; from the fastest to 50, the paper's choice: {percents(fifty)} more.",
        f"The fastest is one of 50, 100, 200 by more than {delta:.1f} % in {times(pro, n)} of {n} cases, "
        f"one outside in {times(len(against), n)}, and the two are within {delta:.1f} % "
        f"in {times(open_, n)}.",
    ]
    return sentences + [nmax_verdict(against, n)]


def nmax_verdict(against, n):
    """Is 50 to 200 best, as the paper says? `against`: {case: percent} where a value outside is faster."""
    outside = ""
    if against:
        order, distribution = worst = max(against, key=against.get)
        outside = f"a value outside is up to {against[worst]:.1f} % faster ({order}, {distribution})."
    holding = n - len(against)
    if holding == 0:
        return f"**The paper's 50 to 200 does not hold** in any of {n} cases: {outside}"
    where = f"in all {n} cases" if holding == n else f"in {holding} of {n} cases"
    return (
        f"**The paper's 50 to 200 holds {where}**: one of 50, 100, 200 is as fast as any value "
        "outside, or faster." + (f" Elsewhere {outside}" if outside else "")
    )


# --- In short --------------------------------------------------------------------------------------


def lead_sentence(here, paper, over, name):
    """HG over another system, in total and, where there is one, by insertion."""
    ours, theirs = (less_or_more(gains(rows, "HG", over).values()) for rows in (here, paper))
    inserting = gains(here, "HG", over, "insert").values()
    more = f"; insertion alone {less_or_more(inserting)}" if inserting else ""
    return f"HG as in the paper took {ours} than {name} (the paper: {theirs}){more}."


def in_short(here, paper, ablated, cgal):
    """The first sentences of the report."""
    lines = [
        lead_sentence(here, paper, over, name)
        for over, name in (("CGAL", cgal), ("MG", "MG"), ("RG", "RG"))
        if gains(here, "HG", over)
    ]
    ours, theirs = (gains(rows, "MG", "CGAL").values() for rows in (here, paper))
    if ours:
        lines.append(
            f"MG, on the same kernel, took {less_or_more(ours)} than {cgal} (the paper: "
            f"{less_or_more(theirs)}); only what HG gains beyond that is the order's."
        )
    for over in ("CGAL", "HG"):
        ours = gains(here, "default", over).values()
        if ours:
            lines.append(f"Our default took {less_or_more(ours)} than {cgal if over == 'CGAL' else over}.")
    for points in ablated.sizes:
        lines.append(f"Nmax, at {points:,} points: {nmax_sentences(ablated, points)[-1]}")
    return lines
