"""One module per command: `add(commands)` declares its arguments, `run(args, job)` returns its record."""
