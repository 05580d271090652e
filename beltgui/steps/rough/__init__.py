"""Step 3, rough workpiece: a first pose of the blade."""
