"""Step 2, base: the measurement frame in the robot base."""
