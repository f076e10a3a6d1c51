"""What every study needs: config, catalogue of figures and claims, pages."""
