"""Birth and decay of tensional wrinkles: Panaitescu et al., PRE 100, 053003 (2019)."""
