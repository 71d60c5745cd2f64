# SPDX-License-Identifier: BSD-3-Clause
"""The colours of all figures. One meaning each: blue the order, vermillion the point or step to look at,
orange what is long or removed, green what is new or first."""

# Okabe and Ito's colours, which colour-blind readers can tell apart; tints of them; greys.
BLUE, VERMILLION, ORANGE, GREEN, SKY, PURPLE = (
    "#0072b2", "#d55e00", "#e69f00", "#009e73", "#56b4e9", "#cc79a7")  # fmt: skip
INK, GREY, PALE, PAPER = "#222222", "#8c929a", "#c3c8ce", "#ffffff"
LIGHT_BLUE, LIGHT_ORANGE, LIGHT_GREEN = "#b5daf2", "#f7cf85", "#a8dcc9"
RAMP = ("#440154", "#3b528b", "#21918c", "#5ec962", "#fde725")  # viridis: dark first, light last


def rgb(colour):
    """Three numbers from 0 to 1."""
    return [int(colour[k : k + 2], 16) / 255.0 for k in (1, 3, 5)]
