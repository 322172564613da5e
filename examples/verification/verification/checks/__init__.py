"""One module a topic; each registers its checks with @check(...)."""
