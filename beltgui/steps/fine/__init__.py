"""Step 4, fine workpiece: the pose of the blade from its machined faces."""
