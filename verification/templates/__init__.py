"""The template of the page; `page` renders it."""
