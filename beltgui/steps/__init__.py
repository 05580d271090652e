"""The six steps without a screen: acquire, solve, judge, keep. Wizard, command line and tests share them."""
