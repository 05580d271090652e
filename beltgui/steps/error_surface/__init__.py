"""Step 6, error surface: what the blade is off where the wheel touches it."""
