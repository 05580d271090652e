"""Rough workpiece: the blade's first pose in the measurement frame, from picked pairs or from the scan alone."""

from core.rough.automatic import Candidate, Confirm, GlobalFit, GlobalSettings, find_candidates, register_globally
from core.rough.judge import PairsLimits, judge_pairs
from core.rough.pairs import PairsFit, solve_pairs

__all__ = ["Candidate", "Confirm", "GlobalFit", "GlobalSettings", "PairsFit", "PairsLimits", "find_candidates",
           "judge_pairs", "register_globally", "solve_pairs"]
