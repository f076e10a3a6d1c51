"""What any study needs: config, catalogue of figures and claims, pages."""
