"""The command line `beltcal`: arguments in, JSON or a table out, an exit code. It computes nothing itself."""
