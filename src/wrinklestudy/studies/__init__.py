"""The studies that come with the package, each a folder with theory, figures and claims."""
