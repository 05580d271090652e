"""Commissioning runs that are killed at random moments: what is lost, what is left half-written, do they go on?"""
