"""Efficiency of every estimator: is the stated covariance true, and does it reach the Cramér–Rao bound?"""
