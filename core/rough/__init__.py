"""Rough workpiece: the blade's first pose in the measurement frame, from picked pairs or from the scan alone."""

from core.rough.judge import PairsLimits, judge_pairs
from core.rough.pairs import PairsFit, solve_pairs

__all__ = ["PairsFit", "PairsLimits", "judge_pairs", "solve_pairs"]
