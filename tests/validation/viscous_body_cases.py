"""Bodies in viscous fluid."""
ALL = []
