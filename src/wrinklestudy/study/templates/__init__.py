"""Templates of pages; `pages` renders them, and the digest of a job that imports it has them."""
