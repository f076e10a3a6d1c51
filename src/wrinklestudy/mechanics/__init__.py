"""Energy at a point: material laws, the cross-section, the plate."""
